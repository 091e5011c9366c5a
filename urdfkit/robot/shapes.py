"""Shapes of a link as solids in its frame: extent, volume, mass properties.

Lengths in m. Meshes are solids once they are measured: see `MeshSolid`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from functools import cached_property
from math import dist, hypot, pi, sqrt

from urdfkit.core.record import Record
from urdfkit.core.spatial import AXES, Transform, Vector, dot, minus, rotate, transposed, vector
from urdfkit.robot import inertia
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.link import Body, Link, Shape, Tensor
from urdfkit.robot.model import RobotModel
from urdfkit.robot.values import numbers
from urdfkit.text.document import Attribute

#: Half edges outside this range, in m, are implausible for robots, and their cubes overflow.
MIN_HALF_EDGE, MAX_HALF_EDGE = 1e-7, 1e5

#: The attributes of each primitive that are lengths.
SIZES = {
    "box": ("size",),
    "cylinder": ("radius", "length"),
    "capsule": ("radius", "length"),
    "sphere": ("radius",),
}

#: Two shapes of a link are in different units if one is longer by this factor (GEO004); which of
#: them is correct is unknown.
OTHER_UNIT = 5.0


class BoundingBox(Record):
    """A box along the axes of a frame."""

    low: Vector
    high: Vector

    @classmethod
    def of(cls, points: Iterable[Vector]) -> BoundingBox:
        """The bounding box of one or more points."""
        columns = tuple(zip(*points, strict=True))
        return cls(vector(map(min, columns)), vector(map(max, columns)))

    @classmethod
    def around(cls, boxes: Iterable[BoundingBox]) -> BoundingBox:
        """The bounding box of one or more boxes."""
        return cls.of(corner for box in boxes for corner in box)

    def moved(self, frame: Transform) -> BoundingBox:
        """The bounding box of this box, transformed from a frame to its parent frame."""
        half = [edge / 2 for edge in self.edges]
        reach = [sum(abs(r) * h for r, h in zip(row, half, strict=True)) for row in frame.rotation]
        center = frame.apply(self.center)
        low = (a - b for a, b in zip(center, reach, strict=True))
        high = (a + b for a, b in zip(center, reach, strict=True))
        return BoundingBox(vector(low), vector(high))

    @property
    def edges(self) -> Vector:
        """Edge lengths in m."""
        return minus(self.high, self.low)

    @property
    def center(self) -> Vector:
        """Centre in m."""
        return vector((low + high) / 2 for low, high in zip(self.low, self.high, strict=True))

    @property
    def volume(self) -> float:
        """Volume in m^3."""
        x, y, z = self.edges
        return x * y * z

    def gap(self, other: BoundingBox) -> float:
        """Largest distance of two boxes along an axis, in m; negative if they overlap."""
        return max(max(a - d, c - b) for a, b, c, d in zip(*self, *other, strict=True))

    def common_volume(self, other: BoundingBox) -> float:
        """Volume of the intersection in m^3."""
        volume = 1.0
        for low, high, low2, high2 in zip(*self, *other, strict=True):
            volume *= max(0.0, min(high, high2) - max(low, low2))
        return volume


class Primitive(Record):
    """A box, cylinder, sphere or capsule with positive sizes."""

    kind: str  # ``box``, ``cylinder``, ``sphere`` or ``capsule``
    size: Vector  # edges of a box along x, y, z; zeros for the other kinds
    radius: float  # 0 for a box
    length: float  # of a cylinder along z, or between the centres of a capsule's ends; else 0
    origin: Transform  # in the frame of the link

    @property
    def volume(self) -> float:
        """Volume in m^3."""
        if self.kind == "box":
            return self.size[0] * self.size[1] * self.size[2]
        ends = 0.0 if self.kind == "cylinder" else 4 * self.radius / 3
        return pi * self.radius * self.radius * (self.length + ends)

    @property
    def longest(self) -> float:
        """The largest extent along its axes, in m."""
        if self.kind == "box":
            return max(self.size)
        ends = 2 * self.radius if self.kind == "capsule" else 0.0
        return max(2 * self.radius, self.length + ends)

    def properties(self, mass: float) -> MassProperties:
        """Mass properties of the solid with uniform density, in the frame of the link."""
        tensor = inertia.rotated(self._tensor(mass), self.origin.rotation)
        return MassProperties(mass, self.origin.position, tensor)

    def _tensor(self, mass: float) -> Tensor:
        if self.kind == "box":
            return inertia.box(mass, self.size)
        if self.kind == "sphere":
            return inertia.sphere(mass, self.radius)
        if self.kind == "capsule":
            return inertia.capsule(mass, self.radius, self.length)
        return inertia.cylinder(mass, self.radius, self.length)

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the farthest point of the solid."""
        offset = minus(point, self.origin.position)
        x, y, z = map(abs, rotate(transposed(self.origin.rotation), offset))
        if self.kind == "box":
            a, b, c = self.size
            return hypot(x + a / 2, y + b / 2, z + c / 2)
        if self.kind == "cylinder":
            return hypot(hypot(x, y) + self.radius, z + self.length / 2)
        return hypot(x, y, z + self.length / 2) + self.radius

    def reach(self, direction: Vector) -> float:
        """Support function of the solid: its extent from the origin along a unit vector."""
        center = dot(self.origin.position, direction)
        u, v, w = map(abs, rotate(transposed(self.origin.rotation), direction))
        if self.kind == "box":
            a, b, c = self.size
            return center + (a * u + b * v + c * w) / 2
        across = sqrt(max(0.0, 1 - w * w)) if self.kind == "cylinder" else 1.0
        return center + w * self.length / 2 + self.radius * across

    def __str__(self) -> str:
        """For example ``cylinder of radius 0.06 m and length 0.05 m``."""
        if self.kind == "box":
            return "box of {:g} x {:g} x {:g} m".format(*self.size)
        length = f" and length {self.length:g} m" if self.length else ""
        return f"{self.kind} of radius {self.radius:g} m{length}"


class MeshSolid(Record):
    """A mesh as a solid in the frame of a link."""

    name: str  # of the file
    shape_mass: MassProperties  # of the mesh, or of its convex hull, at a density of 1 kg/m³
    hull: float  # volume of the convex hull in m^3
    is_closed: bool  # False if the convex hull replaces the mesh
    #: Extreme vertices; the extent of the mesh is hardly larger in any direction.
    points: tuple[Vector, ...]

    @property
    def volume(self) -> float:
        """Volume in m^3."""
        return self.shape_mass.mass

    @property
    def origin(self) -> Transform:
        """The centre of mass at uniform density, with the axes of the link."""
        return Transform(position=self.shape_mass.center)

    @property
    def longest(self) -> float:
        """The longest edge of its bounding box, in m."""
        edges: list[float] = [max(x) - min(x) for x in zip(*self.points, strict=True)]
        return max(edges)

    def properties(self, mass: float) -> MassProperties:
        """Mass properties of the solid with uniform density, in the frame of the link."""
        tensor = inertia.scaled(self.shape_mass.tensor, mass / self.volume)
        return self.shape_mass._replace(mass=mass, tensor=tensor)

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the farthest point of the mesh."""
        return max(dist(point, vertex) for vertex in self.points)

    def reach(self, direction: Vector) -> float:
        """Extent of the mesh from the origin of the link along a unit vector."""
        return max(dot(direction, point) for point in self.points)

    def __str__(self) -> str:
        """For example ``mesh 'arm.stl' of 0.0012 m^3``."""
        kind = "mesh" if self.is_closed else "convex hull of the mesh"
        return f"{kind} '{self.name}' of {self.volume:.3g} m³"


class LinkSolid:
    """The union of the shapes of a link, over which its mass is distributed."""

    def __init__(self, parts: tuple[Primitive | MeshSolid, ...]) -> None:
        self.parts = parts

    @cached_property
    def volume(self) -> float:
        """Volume in m^3; overlaps count twice."""
        return sum(part.volume for part in self.parts)

    def properties(self, mass: float) -> MassProperties:
        """Mass properties of the solid with uniform density; overlaps are twice as dense."""
        density = mass / self.volume
        return inertia.combined(part.properties(density * part.volume) for part in self.parts)

    @property
    def minimum_volume(self) -> float:
        """Volume in m^3 without the meshes that are not closed."""
        return sum(
            0.0 if isinstance(part, MeshSolid) and not part.is_closed else part.volume
            for part in self.parts
        )

    @property
    def maximum_volume(self) -> float:
        """Volume in m^3 with the convex hulls of all meshes."""
        return sum(part.hull if isinstance(part, MeshSolid) else part.volume for part in self.parts)

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the farthest point of the solid."""
        return max(part.farthest(point) for part in self.parts)

    def reach(self, direction: Vector) -> float:
        """Extent of the solid from the origin of the link along a unit vector."""
        return max(part.reach(direction) for part in self.parts)

    @cached_property
    def bounds(self) -> BoundingBox:
        """The bounding box along the axes of the link."""
        low = (-self.reach((-x, -y, -z)) for x, y, z in AXES)
        return BoundingBox(vector(low), vector(map(self.reach, AXES)))

    def __str__(self) -> str:
        if len(self.parts) == 1:
            return str(self.parts[0])
        kind = "shapes" if any(isinstance(part, MeshSolid) for part in self.parts) else "primitives"
        return f"union of {len(self.parts)} {kind}"


def solid(
    bodies: Iterable[Body], mesh_solid: Callable[[Body], MeshSolid | None] | None = None
) -> LinkSolid | None:
    """The solid of visuals or collisions.

    None without shapes, or if one is neither a primitive of plausible size nor a measured mesh.
    """
    parts: list[Primitive | MeshSolid] = []
    for body in bodies:
        part = primitive(body) or (mesh_solid(body) if mesh_solid else None)
        if part is None:
            return None
        parts.append(part)
    return LinkSolid(tuple(parts)) if parts else None


def primitive(body: Body) -> Primitive | None:
    """The primitive of a visual or collision; None for other shapes and implausible sizes."""
    shape = body.shape
    extents = shape.half_extents if shape else None
    if shape is None or extents is None:
        return None
    if not MIN_HALF_EDGE <= min(extents) <= max(extents) <= MAX_HALF_EDGE:
        return None
    size = shape.size if shape.kind == "box" and shape.size else (0.0, 0.0, 0.0)
    radius = 0.0 if shape.kind == "box" else shape.radius or 0.0
    length = shape.length or 0.0 if shape.kind in ("cylinder", "capsule") else 0.0
    if length < 0 or radius < 0:  # the half extents of a capsule may still be positive
        return None
    return Primitive(shape.kind, size, radius, length, body.origin)


def shaped(model: RobotModel) -> Iterator[tuple[Link, Body, Shape]]:
    """All shapes, each with its link and its visual or collision."""
    for link in model.links:
        for body in link.bodies:
            if body.shape:
                yield link, body, body.shape


def sizes(shape: Shape) -> Iterator[tuple[Attribute, tuple[float, ...]]]:
    """The attributes of a primitive that are lengths, with their readable values in m."""
    for key in SIZES.get(shape.kind, ()):
        attribute = shape.at.attributes.get(key)
        values = numbers(attribute.value) if attribute else None
        if attribute and values and len(values) == (3 if key == "size" else 1):
            yield attribute, values
