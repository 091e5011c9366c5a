"""A launch file in XML, and the values of its attributes."""

from urdfkit.ros.launch.collect import Collector, path_from
from urdfkit.ros.launch.contents import LaunchedFile
from urdfkit.ros.launch.signature import USE
from urdfkit.ros.launch.substitutions import Substitutions
from urdfkit.text.document import Attribute, Element


class XmlLaunchFile:
    """A launch file with the known values of its arguments.

    Attributes:
        values: of the arguments; extended while the file is read.
        frame: the launch files that include it.
        ros: 1 or 2; None if unknown.
        unknown_conditions: number of enclosing conditions that are known only at run time.
    """

    def __init__(self, collector: Collector, file: LaunchedFile) -> None:
        self.collector = collector
        self.source = file.source
        self.values = {name: value for name, value in file.arguments.items() if value is not None}
        self.substitutions = Substitutions(collector, self.source, self.values)
        self.frame = file.frame
        self.ros: int | None = None
        self.unknown_conditions = 0

    def text(self, attribute: Attribute | None) -> str | None:
        """The value of an attribute; None if known only at run time."""
        return self.substitutions.text(attribute.value, attribute.span) if attribute else None

    def path(self, attribute: Attribute) -> str | None:
        """The path in an attribute; None if it needs an argument that is still empty."""
        if any(self.values.get(name) == "" for name in USE.findall(attribute.value)):
            return None
        text = self.text(attribute)
        return None if text is None else path_from(self.source, text)

    def is_off(self, element: Element) -> bool:
        """True if a condition disables an element; an unknown condition does not."""
        for name, off in (("if", ("false", "0")), ("unless", ("true", "1"))):
            if (self.text(element.attributes.get(name)) or "").strip().lower() in off:
                return True
        return False

    def has_unknown_condition(self, element: Element) -> bool:
        """True if the condition of an element is known only at run time."""
        conditions = (element.attributes.get(name) for name in ("if", "unless"))
        return any(condition and self.text(condition) is None for condition in conditions)
