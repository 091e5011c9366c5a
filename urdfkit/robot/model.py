"""The robot model of a document: its links, joints and materials."""

from collections.abc import Mapping
from functools import cached_property

from urdfkit.core.static_typing import TypeVar
from urdfkit.errors import UrdfkitError
from urdfkit.robot.joint import Joint, read_joint
from urdfkit.robot.link import Body, Link, Shape, read_link, read_material
from urdfkit.text.document import Document, Element
from urdfkit.text.source import Span


class UnknownLink(UrdfkitError):
    """A link does not exist, or is not connected to the requested link."""


class RobotModel:
    """A robot as described by its URDF.

    Attributes:
        document: the source document.
        root: the ``<robot>`` element.
        name: of the robot; empty if it is missing.
        links, joints, materials: in the order of the document, duplicates included.
        gazebo, transmissions, ros2_controls: the elements with these tags.
        packages: directories of the ROS packages that were known when it was read, by name.
    """

    def __init__(self, document: Document, packages: Mapping[str, str] | None = None) -> None:
        self.document = document
        self.packages = dict(packages or {})
        self.root = root = document.root
        self.name = root.get("name") or ""
        self.links = tuple(read_link(element) for element in root.all("link"))
        self.joints = tuple(read_joint(element) for element in root.all("joint"))
        self.materials = tuple(read_material(element) for element in root.all("material"))
        self.gazebo = tuple(root.all("gazebo"))
        self.transmissions = tuple(root.all("transmission"))
        self.ros2_controls = tuple(root.all("ros2_control"))

    @cached_property
    def links_by_name(self) -> dict[str, Link]:
        """The first link of each name."""
        return _first_by_name(self.links)

    @cached_property
    def joints_by_name(self) -> dict[str, Joint]:
        """The first joint of each name."""
        return _first_by_name(self.joints)

    def require_link(self, name: str) -> Link:
        """The first link of a name.

        Raises:
            UnknownLink: no link has this name; the message suggests the nearest name.
        """
        if name not in self.links_by_name:
            from urdfkit.core.suggest import did_you_mean

            raise UnknownLink(f"no link '{name}'{did_you_mean(name, self.links_by_name)}")
        return self.links_by_name[name]

    def place(self, name: str = "") -> Span:
        """Span of the first link or joint with a name; of the robot if there is none."""
        part = self.links_by_name.get(name) or self.joints_by_name.get(name)
        return (part.at if part else self.root).span

    def collision(self, link: str, number: int) -> Element:
        """The element of a collision of a link, by its number from 0."""
        return self.links_by_name[link].collisions[number].at

    @property
    def mass(self) -> float:
        """Total mass of all links, in kg."""
        return sum(link.mass for link in self.links)

    @property
    def degrees_of_freedom(self) -> int:
        """Total degrees of freedom of all joints."""
        return sum(joint.degrees_of_freedom for joint in self.joints)

    @property
    def visuals(self) -> list[Body]:
        """The visuals of all links."""
        return [body for link in self.links for body in link.visuals]

    @property
    def collisions(self) -> list[Body]:
        """The collisions of all links."""
        return [body for link in self.links for body in link.collisions]

    @property
    def shapes(self) -> list[Shape]:
        """All shapes of all visuals and collisions."""
        bodies = (body for link in self.links for body in link.bodies)
        return [body.shape for body in bodies if body.shape]


Named = TypeVar("Named", Link, Joint)


def _first_by_name(parts: tuple[Named, ...]) -> dict[str, Named]:
    first: dict[str, Named] = {}
    for part in parts:
        if part.name:
            first.setdefault(part.name, part)
    return first
