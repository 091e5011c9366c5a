"""The result of a conversion for every element and attribute of a robot."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from enum import Enum

from urdfkit.core.record import Record
from urdfkit.robot.origin import reads_quaternions
from urdfkit.text.document import Attribute, Element
from urdfkit.text.source import Span


class Result(str, Enum):
    """Result of the conversion of an element or attribute."""

    KEPT = "kept"
    APPROXIMATED = "approximated"
    LOST = "lost"


class Entry(Record):
    """An element or attribute, and the result of its conversion."""

    part: str  # path in the expanded robot, such as ``joint/elbow/limit@velocity``
    tag: str  # tag of the element, or name of the attribute
    span: Span  # source location
    result: Result
    note: str  # what it becomes, its deviation, or why it is lost


#: Attributes that are kept with their element.
_OWN = {
    "robot": ("name",),
    "link": ("name",),
    "joint": ("name", "type"),
    "origin": ("xyz", "rpy", "quat_xyzw"),
    "parent": ("link",),
    "child": ("link",),
    "axis": ("xyz",),
    "limit": ("lower", "upper"),
    "mass": ("value",),
    "inertia": ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"),
    "box": ("size",),
    "sphere": ("radius",),
    "cylinder": ("radius", "length"),
    "capsule": ("radius", "length"),
    "mesh": ("filename", "scale"),
    "material": ("name",),
    "color": ("rgba",),
    "texture": ("filename",),
    "mimic": ("joint", "multiplier", "offset"),
    "gazebo": ("reference",),
    "sensor": ("name", "type"),
    "pose": ("relative_to", "rotation_format", "degrees"),
    "mu1": ("value",),
    "mu2": ("value",),
}
#: Elements of which only the first one in a link, joint, visual, collision or inertial is used.
_SINGLE = frozenset(
    "axis calibration child dynamics geometry inertia inertial limit mass mimic origin parent "
    "safety_controller".split()
)


class LossTable:
    """Collects the entries of a conversion; unrecorded parts are lost."""

    def __init__(self) -> None:
        self._marks: dict[int, tuple[Result, str]] = {}

    def keep(self, part: Element | Attribute | None, note: str, *children: str) -> None:
        """Record that an element with its own attributes, or an attribute, is kept.

        Args:
            children: tags of children of the element, which are kept, too.
        """
        self._mark(part, Result.KEPT, note)
        for tag in children:
            assert isinstance(part, Element)
            self._mark(part.child(tag), Result.KEPT, note)

    def approximate(self, part: Element | Attribute | None, note: str) -> None:
        """Like `keep`, for a part that is only approximated."""
        self._mark(part, Result.APPROXIMATED, note)

    def lose(self, part: Element | Attribute | None, note: str) -> None:
        """Record why a part is lost, with all of its contents; overrides other reasons."""
        self._mark(part, Result.LOST, note)

    def _mark(self, part: Element | Attribute | None, result: Result, note: str) -> None:
        if part is None:
            return
        self._marks[id(part)] = result, note
        if isinstance(part, Element) and result is not Result.LOST:
            for name in _OWN.get(part.tag, ()):
                if name in part.attributes and (name != "quat_xyzw" or reads_quaternions(part)):
                    self._marks.setdefault(id(part.attributes[name]), (result, note))

    def entries(self, root: Element, otherwise: str, reasons: Mapping[str, str]) -> Iterator[Entry]:
        """Every element and attribute of a robot but namespaces, in the order of the document.

        Args:
            otherwise: the reason why an unrecorded part is lost.
            reasons: reasons by the tag of an element, or ``@name`` of an attribute.
        """
        lost = Result.LOST, otherwise
        for element in root.walk():
            above = self._marks.get(id(element.parent), lost)
            own_reason = Result.LOST, _repeated(element) or reasons.get(element.tag, otherwise)
            inherited = above if above[0] is Result.LOST and above != lost else own_reason
            mark = self._marks.setdefault(id(element), inherited)
            yield Entry(element.path, f"<{element.tag}>", element.span, *mark)
            inherited = mark if mark[0] is Result.LOST else lost
            for name, attribute in element.attributes.items():
                if name.startswith("xmlns"):
                    continue  # a declaration, of xacro's namespace
                reason = Result.LOST, reasons.get(f"@{name}", inherited[1])
                own = self._marks.get(id(attribute), inherited if inherited != lost else reason)
                yield Entry(f"{element.path}@{name}", name, attribute.span, *own)


def _repeated(element: Element) -> str:
    """Why a repeated element is lost; empty for other elements."""
    parent = element.parent
    if parent is None:
        return ""
    if parent.tag == "geometry" and parent.children[0] is not element:
        return "only the first shape in <geometry> is read"
    if element.tag in _SINGLE and parent.child(element.tag) is not element:
        return f"only the first <{element.tag}> is read"
    return ""
