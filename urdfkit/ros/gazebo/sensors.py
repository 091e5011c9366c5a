"""The sensors in the ``<gazebo>`` tags of a model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.robot.model import RobotModel
from urdfkit.robot.placed import Placed
from urdfkit.robot.values import number
from urdfkit.ros.catalog.sensors import Setting, settings
from urdfkit.text.document import Attribute, Element


class Sensor(Record):
    """A ``<sensor>``."""

    at: Element
    #: name and type: as written; empty if missing.
    name: str
    type: str
    reference: str  # the link or joint of the enclosing ``<gazebo>``; empty without a reference

    @property
    def who(self) -> str:
        return f"sensor '{self.name}'"

    def find(self, path: str) -> Element | None:
        """The first element at a path below the sensor."""
        element: Element | None = self.at
        for tag in path.split("/"):
            element = element.child(tag) if element else None
        return element

    def number(self, path: str) -> Placed[float] | None:
        """The number in the element at a path, if any."""
        element = self.find(path)
        value = number(element.text.strip()) if element else None
        return None if element is None or value is None else Placed(value, element)

    @property
    def lidar(self) -> str:
        """``ray`` or ``lidar``, the tag with the settings; empty for other sensors."""
        return next((tag for tag in ("lidar", "ray") if self.at.child(tag)), "")

    @property
    def plugins(self) -> list[Element]:
        return self.at.all("plugin")


class SettingElement(Record):
    """An element in the block of a sensor's settings."""

    at: Element  # the element
    parent: str  # tag of its parent
    path: str  # relative to the block
    known: Mapping[str, Setting]  # valid settings of the block, by path

    @property
    def setting(self) -> Setting | None:
        """Its definition in SDF; None if it is not in SDF."""
        return self.known.get(self.path)

    @property
    def siblings(self) -> tuple[str, ...]:
        """The valid tags in its parent."""
        parent_path = "".join(self.path.rpartition("/")[:2])
        inside = [path for path in self.known if path.startswith(parent_path)]
        tags = (path.removeprefix(parent_path) for path in inside)
        return tuple(tag for tag in tags if tag and "/" not in tag and "@" not in tag)

    @property
    def has_type_attribute(self) -> bool:
        """True for noise of a single quantity; noise of images and scans has a ``<type>``."""
        return self.at.tag == "noise" and "/" in self.path

    def attributes(self) -> Iterator[tuple[Attribute, Setting]]:
        """Its attributes with their definitions in SDF; unknown attributes are ignored."""
        known, path = self.known, f"{self.path}/"
        if self.has_type_attribute:
            known, path = settings("noise"), ""
        for name, attribute in self.at.attributes.items():
            if setting := known.get(f"{path}@{name}"):
                yield attribute, setting


def written(sensor: Sensor) -> Iterator[SettingElement]:
    """The elements below the blocks of a sensor; contents of unknown elements are ignored."""
    for block in sensor.at.children:
        known = settings(block.tag)
        if not known:
            continue
        stack = [("", child, known) for child in reversed(block.children)]
        while stack:
            path, element, known = stack.pop()
            path += element.tag
            parent_tag = element.parent.tag if element.parent else block.tag
            yield SettingElement(element, parent_tag, path, known)
            if path not in known:
                continue
            if element.tag == "noise":
                path, known = "", settings("noise")
            else:
                path += "/"
            stack += [(path, child, known) for child in reversed(element.children)]


def sensors(model: RobotModel) -> Iterator[Sensor]:
    """The sensors of a model, in document order."""
    for gazebo in model.gazebo:
        for element in gazebo.all("sensor"):
            yield Sensor(
                element,
                element.get("name") or "",
                element.get("type") or "",
                gazebo.get("reference") or "",
            )
