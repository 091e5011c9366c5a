"""The sensors in the ``<gazebo>`` tags of a model."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.model import Placed, number
from urdfkit.record import Record
from urdfkit.static import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.document import Element
    from urdfkit.model import RobotModel


class Sensor(Record):
    """A ``<sensor>``.

    Attributes:
        at: its element.
        name, type: as written; empty where there is none.
        reference: the link or joint of the ``<gazebo>`` around it; empty without one.
    """

    at: Element
    name: str
    type: str
    reference: str

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
        """The number in the element at a path, if there is one."""
        element = self.find(path)
        value = number(element.text.strip()) if element else None
        return None if element is None or value is None else Placed(value, element)

    @property
    def lidar(self) -> str:
        """``ray`` or ``lidar``, whichever holds the settings; empty for other sensors."""
        return next((tag for tag in ("lidar", "ray") if self.at.child(tag)), "")

    @property
    def plugins(self) -> list[Element]:
        return self.at.all("plugin")


def sensors(model: RobotModel) -> Iterator[Sensor]:
    """The sensors of a model, in the order of the document."""
    for gazebo in model.gazebo:
        for element in gazebo.all("sensor"):
            yield Sensor(
                element,
                element.get("name") or "",
                element.get("type") or "",
                gazebo.get("reference") or "",
            )
