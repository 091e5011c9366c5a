"""Links: their inertia, visuals and collisions, with source locations.

Parsing is tolerant: a value that cannot be parsed is None here, and the grammar rules report it,
so that one bad number does not hide the rest. Units are those of URDF: m, rad, kg, N and N·m.
"""

from __future__ import annotations

from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Transform, Vector
from urdfkit.robot.origin import read_origin
from urdfkit.robot.placed import Placed, placed_number, placed_text
from urdfkit.robot.values import number, numbers, vector
from urdfkit.text.document import Element


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

    @property
    def file(self) -> Placed[str] | None:
        """The file name of its mesh; None for another shape."""
        return self.shape.filename if self.shape else None

    @property
    def is_mesh(self) -> bool:
        return self.shape is not None and self.shape.kind == "mesh"


class Link(Record):
    """``<link>``; the name is ``""`` if it is missing."""

    at: Element
    name: str
    inertial: Inertial | None
    visuals: tuple[Body, ...]
    collisions: tuple[Body, ...]

    @property
    def bodies(self) -> tuple[Body, ...]:
        """The visuals, then the collisions."""
        return self.visuals + self.collisions

    @property
    def mass(self) -> float:
        """The mass in kg; 0 if it is missing or unreadable."""
        return self.inertial.mass.value if self.inertial and self.inertial.mass else 0.0

    @property
    def is_frame(self) -> bool:
        """True if it has no inertial and no shape."""
        return not (self.inertial or self.visuals or self.collisions)


def read_link(element: Element) -> Link:
    """The link of a ``<link>``."""
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
    mass = placed_number(element.child("mass"), "value")
    return Inertial(element, mass, placed, read_origin(element))


def _body(element: Element) -> Body:
    geometry = element.child("geometry")
    material = element.child("material")
    return Body(
        element,
        read_origin(element),
        _shape(geometry.children[0]) if geometry and geometry.children else None,
        read_material(material) if material else None,
    )


def _shape(element: Element) -> Shape:
    return Shape(
        element,
        element.tag,
        vector(element.get("size")),
        number(element.get("radius")),
        number(element.get("length")),
        placed_text(element, "filename") if element.tag == "mesh" else None,
        _scale(element.get("scale")),
    )


def _scale(text: str | None) -> Vector:
    """The scale of a mesh; one number, which Drake reads, is that of all directions."""
    values = numbers(text) or ()
    if len(values) == 1 and values[0]:
        return values * 3
    return vector(text) or (1.0, 1.0, 1.0)


def read_material(element: Element) -> Material:
    """The material of a ``<material>``."""
    color, texture = element.child("color"), element.child("texture")
    rgba = color.attributes.get("rgba") if color else None
    values = numbers(rgba.value) if rgba else None
    return Material(
        element,
        placed_text(element, "name"),
        Placed(values, rgba) if rgba and values else None,
        placed_text(texture, "filename"),
    )
