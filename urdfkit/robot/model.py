"""The robot model of a document: links, joints and their values with source locations.

Parsing is tolerant: a value that cannot be parsed is None here, and the grammar rules report it,
so that one bad number does not hide the rest. Units are those of URDF: m, rad, kg, N and N·m.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import cached_property

from urdfkit.core.record import Record
from urdfkit.core.spatial import (
    IDENTITY,
    ORIGIN,
    Rotation,
    Transform,
    Vector,
    from_quaternion,
    from_rpy,
)
from urdfkit.core.static_typing import Generic, TypeVar
from urdfkit.errors import UrdfkitError
from urdfkit.robot.values import number, numbers, vector
from urdfkit.text.document import Attribute, Document, Element, Step
from urdfkit.text.schema import VERSIONS
from urdfkit.text.source import Span

T = TypeVar("T", covariant=True)


class UnknownLink(UrdfkitError):
    """A link does not exist, or is not connected to the requested link."""


#: By joint type; a planar joint has two translations and a rotation.
DEGREES_OF_FREEDOM = {"revolute": 1, "continuous": 1, "prismatic": 1, "planar": 3, "floating": 6}
#: Types of joints with one coordinate, an angle or a distance.
SINGLE_DOF = ("revolute", "continuous", "prismatic")


class Placed(Generic[T]):
    """A value and the element or attribute it was read from."""

    __slots__ = ("at", "value")

    def __init__(self, value: T, at: Element | Attribute) -> None:
        self.value = value
        self.at = at

    @property
    def span(self) -> Span:
        return self.at.span

    @property
    def via(self) -> tuple[Step, ...]:
        return self.at.via

    def __repr__(self) -> str:
        return f"Placed({self.value!r} at {self.at.span})"


class Tensor(Record):
    """The inertia tensor about the centre of mass, in kg·m²."""

    ixx: float
    ixy: float
    ixz: float
    iyy: float
    iyz: float
    izz: float

    @property
    def rows(self) -> Rotation:
        """The tensor as a symmetric 3x3 matrix."""
        xx, xy, xz, yy, yz, zz = self
        return ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))


class Inertial(Record):
    """``<inertial>``; ``origin`` is the frame of the tensor, with the centre of mass."""

    at: Element
    mass: Placed[float] | None
    tensor: Placed[Tensor] | None
    origin: Transform


class Shape(Record):
    """A shape in a ``<geometry>``."""

    at: Element  # the shape's element
    kind: str  # its tag: ``box``, ``cylinder``, ``sphere``, ``capsule``, ``mesh`` or another
    size: Vector | None  # of a box, in m; None for other shapes or if unreadable
    radius: float | None  # of a cylinder, capsule or sphere, in m
    length: float | None  # of a cylinder or capsule, in m
    filename: Placed[str] | None  # of a mesh, as written
    scale: Vector  # of a mesh

    @property
    def half_extents(self) -> Vector | None:
        """Half the bounding box of a primitive about its origin; None for other shapes."""
        radius, length = self.radius, self.length
        if self.kind == "box" and self.size:
            return (self.size[0] / 2, self.size[1] / 2, self.size[2] / 2)
        if self.kind == "sphere" and radius is not None:
            return (radius, radius, radius)
        if self.kind in ("cylinder", "capsule") and radius is not None and length is not None:
            return (radius, radius, length / 2 + (radius if self.kind == "capsule" else 0.0))
        return None


class Material(Record):
    """``<material>`` of the robot or of a visual."""

    at: Element
    name: Placed[str] | None
    rgba: Placed[tuple[float, ...]] | None
    texture: Placed[str] | None


class Body(Record):
    """A ``<visual>`` or ``<collision>``; ``shape`` is the first shape in its geometry."""

    at: Element
    origin: Transform
    shape: Shape | None
    material: Material | None


class Link(Record):
    """``<link>``; the name is ``""`` if it is missing."""

    at: Element
    name: str
    inertial: Inertial | None
    visuals: tuple[Body, ...]
    collisions: tuple[Body, ...]

    @property
    def mass(self) -> float:
        """The mass in kg; 0 if it is missing or unreadable."""
        return self.inertial.mass.value if self.inertial and self.inertial.mass else 0.0

    @property
    def is_frame(self) -> bool:
        """True if it has no inertial and no shape."""
        return not (self.inertial or self.visuals or self.collisions)


class Limit(Record):
    """``<limit>``: position in rad or m, effort in N·m or N, velocity in rad/s or m/s."""

    at: Element
    lower: Placed[float] | None
    upper: Placed[float] | None
    effort: Placed[float] | None
    velocity: Placed[float] | None

    @property
    def ends(self) -> tuple[float, float]:
        """The lower and the upper limit; 0 if it is missing or unreadable, as in urdfdom."""
        lower, upper = (end.value if end else 0.0 for end in (self.lower, self.upper))
        return lower, upper


class Mimic(Record):
    """``<mimic>``: position = multiplier * position of the leader + offset."""

    at: Element
    joint: Placed[str] | None
    multiplier: float
    offset: float


class Joint(Record):
    """``<joint>``; ``axis`` is None if it is not written (the default in URDF is x)."""

    at: Element
    name: str
    type: Placed[str] | None
    parent: Placed[str] | None
    child: Placed[str] | None
    origin: Transform
    axis: Placed[Vector] | None
    limit: Limit | None
    mimic: Mimic | None

    @property
    def kind(self) -> str:
        """The type as written; empty if it is missing."""
        return self.type.value if self.type else ""

    @property
    def is_rotational(self) -> bool:
        """True if its position is an angle."""
        return self.kind in ("revolute", "continuous")

    @property
    def is_prismatic(self) -> bool:
        return self.kind == "prismatic"

    @property
    def is_single_dof(self) -> bool:
        """True if its position is one number, in rad or m; also for a mimic joint."""
        return self.kind in SINGLE_DOF

    @property
    def unit(self) -> str:
        """The unit of its position."""
        return "m" if self.is_prismatic else "rad"

    @property
    def effort_unit(self) -> str:
        return "N" if self.is_prismatic else "N·m"

    @property
    def parent_name(self) -> str:
        """Name of the parent link; empty if it is missing."""
        return self.parent.value if self.parent else ""

    @property
    def child_name(self) -> str:
        """Name of the child link; empty if it is missing."""
        return self.child.value if self.child else ""

    @property
    def leader(self) -> str:
        """Name of the joint that it mimics; empty without ``<mimic>``."""
        return self.mimic.joint.value if self.mimic and self.mimic.joint else ""

    @property
    def degrees_of_freedom(self) -> int:
        """Number of independent coordinates; 0 for a mimic joint."""
        return 0 if self.mimic else DEGREES_OF_FREEDOM.get(self.kind, 0)


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
        self.links = tuple(_link(element) for element in root.all("link"))
        self.joints = tuple(_joint(element) for element in root.all("joint"))
        self.materials = tuple(_material(element) for element in root.all("material"))
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
    def shapes(self) -> list[Shape]:
        """All shapes of all visuals and collisions."""
        bodies = (body for link in self.links for body in (*link.visuals, *link.collisions))
        return [body.shape for body in bodies if body.shape]


Named = TypeVar("Named", Link, Joint)


def _first_by_name(parts: tuple[Named, ...]) -> dict[str, Named]:
    first: dict[str, Named] = {}
    for part in parts:
        if part.name:
            first.setdefault(part.name, part)
    return first


def _placed_number(element: Element | None, name: str) -> Placed[float] | None:
    attribute = element.attributes.get(name) if element else None
    value = number(attribute.value) if attribute else None
    return None if attribute is None or value is None else Placed(value, attribute)


def _placed_text(element: Element | None, name: str) -> Placed[str] | None:
    attribute = element.attributes.get(name) if element else None
    return None if attribute is None else Placed(attribute.value, attribute)


def _origin(element: Element) -> Transform:
    origin = element.child("origin")
    if origin is None:
        return Transform()
    return Transform(_rotation(origin), vector(origin.get("xyz")) or ORIGIN)


def _rotation(origin: Element) -> Rotation:
    """The rotation of ``rpy``, or of ``quat_xyzw`` if the URDF version supports it."""
    rpy = vector(origin.get("rpy"))
    if rpy:
        return from_rpy(*rpy)
    quaternion = numbers(origin.get("quat_xyzw")) or ()
    if len(quaternion) == 4 and reads_quaternions(origin):
        return from_quaternion(*quaternion)
    return IDENTITY


def reads_quaternions(element: Element) -> bool:
    """True if urdfdom reads ``quat_xyzw`` in this robot: from URDF 1.1 on."""
    from urdfkit.text.grammar import version_of

    while element.parent is not None:
        element = element.parent
    return version_of(element) != VERSIONS[0]


def _link(element: Element) -> Link:
    inertial = element.child("inertial")
    return Link(
        element,
        element.get("name") or "",
        _inertial(inertial) if inertial else None,
        tuple(_body(body) for body in element.all("visual")),
        tuple(_body(body) for body in element.all("collision")),
    )


def _inertial(element: Element) -> Inertial:
    tensor = element.child("inertia")
    values = (number(tensor.get(key)) for key in Tensor._fields) if tensor else ()
    moments = [moment for moment in values if moment is not None]
    placed = Placed(Tensor(*moments), tensor) if tensor and len(moments) == 6 else None
    mass = _placed_number(element.child("mass"), "value")
    return Inertial(element, mass, placed, _origin(element))


def _body(element: Element) -> Body:
    geometry = element.child("geometry")
    material = element.child("material")
    return Body(
        element,
        _origin(element),
        _shape(geometry.children[0]) if geometry and geometry.children else None,
        _material(material) if material else None,
    )


def _shape(element: Element) -> Shape:
    return Shape(
        element,
        element.tag,
        vector(element.get("size")),
        number(element.get("radius")),
        number(element.get("length")),
        _placed_text(element, "filename") if element.tag == "mesh" else None,
        _scale(element.get("scale")),
    )


def _scale(text: str | None) -> Vector:
    """The scale of a mesh; one number, which Drake reads, is that of all directions."""
    values = numbers(text) or ()
    if len(values) == 1 and values[0]:
        return values * 3
    return vector(text) or (1.0, 1.0, 1.0)


def _material(element: Element) -> Material:
    color, texture = element.child("color"), element.child("texture")
    rgba = color.attributes.get("rgba") if color else None
    values = numbers(rgba.value) if rgba else None
    return Material(
        element,
        _placed_text(element, "name"),
        Placed(values, rgba) if rgba and values else None,
        _placed_text(texture, "filename"),
    )


def _joint(element: Element) -> Joint:
    axis, limit, mimic = (element.child(tag) for tag in ("axis", "limit", "mimic"))
    xyz = axis.attributes.get("xyz") if axis else None
    direction = vector(xyz.value) if xyz else None
    return Joint(
        element,
        element.get("name") or "",
        _placed_text(element, "type"),
        _placed_text(element.child("parent"), "link"),
        _placed_text(element.child("child"), "link"),
        _origin(element),
        Placed(direction, xyz) if xyz and direction else None,
        _limit(limit) if limit else None,
        _mimic(mimic) if mimic else None,
    )


def _limit(element: Element) -> Limit:
    keys = ("lower", "upper", "effort", "velocity")
    return Limit(element, *(_placed_number(element, key) for key in keys))


def _mimic(element: Element) -> Mimic:
    multiplier = number(element.get("multiplier"))
    return Mimic(
        element,
        _placed_text(element, "joint"),
        1.0 if multiplier is None else multiplier,
        number(element.get("offset")) or 0.0,
    )
