"""Primitive shapes of a link as solids in its frame: extent, volume, mass properties.

Lengths in m, in the frame of the link. A mesh is none of these; see ``primitives``.
"""

from __future__ import annotations

from collections.abc import Iterable
from math import hypot, pi, sqrt
from typing import NamedTuple

from urdfkit import inertia
from urdfkit.inertia import MassProperties
from urdfkit.model import Body, Shape, Tensor
from urdfkit.spatial import Frame, Vector, rotate, transposed


class Box(NamedTuple):
    """A box about the middle of a bounding box, along its axes."""

    low: Vector
    high: Vector

    @property
    def volume(self) -> float:
        """In m^3."""
        x, y, z = (high - low for low, high in zip(self.low, self.high, strict=True))
        return x * y * z

    def padded(self, margin: float) -> Box:
        """The box with every face moved outwards."""
        x, y, z = self.low
        u, v, w = self.high
        return Box((x - margin, y - margin, z - margin), (u + margin, v + margin, w + margin))

    def overlap(self, other: Box) -> float:
        """Volume of the intersection by volume of the union, from 0 to 1."""
        common = 1.0
        for low, high, low2, high2 in zip(*self, *other, strict=True):
            common *= max(0.0, min(high, high2) - max(low, low2))
        return common / (self.volume + other.volume - common)


class Primitive(NamedTuple):
    """A box, cylinder, sphere or capsule with positive sizes, somewhere in a link."""

    shape: Shape
    origin: Frame

    @property
    def volume(self) -> float:
        """In m^3."""
        shape, radius, length = self.shape, self.shape.radius or 0.0, self.shape.length or 0.0
        if shape.size:
            return shape.size[0] * shape.size[1] * shape.size[2]
        ball = 4 * pi * radius**3 / 3
        if shape.kind == "sphere":
            return ball
        return pi * radius * radius * length + (ball if shape.kind == "capsule" else 0.0)

    def properties(self, mass: float) -> MassProperties:
        """Of the solid with uniform density, in the frame of the link."""
        tensor = inertia.rotated(self._tensor(mass), self.origin.rotation)
        return MassProperties(mass, self.origin.position, tensor)

    def _tensor(self, mass: float) -> Tensor:
        shape, radius, length = self.shape, self.shape.radius or 0.0, self.shape.length or 0.0
        if shape.size:
            return inertia.box(mass, shape.size)
        if shape.kind == "sphere":
            return inertia.sphere(mass, radius)
        if shape.kind == "capsule":
            return inertia.capsule(mass, radius, length)
        return inertia.cylinder(mass, radius, length)

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the farthest point of the solid."""
        x, y, z = map(abs, _local(self.origin, point))
        shape, radius, length = self.shape, self.shape.radius or 0.0, self.shape.length or 0.0
        if shape.size:
            a, b, c = shape.size
            return hypot(x + a / 2, y + b / 2, z + c / 2)
        if shape.kind == "cylinder":
            return hypot(hypot(x, y) + radius, z + length / 2)
        return hypot(x, y, z + length / 2) + radius

    def reach(self, direction: Vector) -> float:
        """How far the solid reaches from the origin of the link in the direction of a unit vector.

        This is the support function of the convex solid.
        """
        u = rotate(transposed(self.origin.rotation), direction)
        center = sum(p * d for p, d in zip(self.origin.position, direction, strict=True))
        shape, radius, length = self.shape, self.shape.radius or 0.0, self.shape.length or 0.0
        if shape.size:
            return center + sum(abs(a * b) for a, b in zip(shape.size, u, strict=True)) / 2
        end = abs(u[2]) * length / 2
        if shape.kind == "cylinder":
            return center + end + radius * sqrt(max(0.0, 1 - u[2] * u[2]))
        return center + end + radius


class Solid(NamedTuple):
    """The primitives of a link that are taken for its matter."""

    parts: tuple[Primitive, ...]

    @property
    def volume(self) -> float:
        """In m^3; where parts overlap, twice."""
        return sum(part.volume for part in self.parts)

    def properties(self, mass: float) -> MassProperties:
        """Of the solid with uniform density; where parts overlap, it is twice as dense."""
        density = mass / self.volume
        return inertia.combined(part.properties(density * part.volume) for part in self.parts)

    def farthest(self, point: Vector) -> float:
        """Distance from a point to the farthest point of the solid."""
        return max(part.farthest(point) for part in self.parts)

    def reach(self, direction: Vector) -> float:
        """How far it reaches from the origin of the link in the direction of a unit vector."""
        return max(part.reach(direction) for part in self.parts)

    @property
    def bounds(self) -> Box:
        """Its bounding box along the axes of the link."""
        axes = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
        low = [-self.reach((-x, -y, -z)) for x, y, z in axes]
        high = [self.reach(axis) for axis in axes]
        return Box((low[0], low[1], low[2]), (high[0], high[1], high[2]))


def solid(bodies: Iterable[Body]) -> Solid | None:
    """The solid that some visuals or collisions make, if all are primitives with positive sizes."""
    parts: list[Primitive] = []
    for body in bodies:
        extents = body.shape.half_extents if body.shape else None
        if body.shape is None or extents is None or min(extents) <= 0:
            return None
        parts.append(Primitive(body.shape, body.origin))
    return Solid(tuple(parts)) if parts else None


def _local(frame: Frame, point: Vector) -> Vector:
    """A point of the parent in a frame."""
    x, y, z = frame.position
    return rotate(transposed(frame.rotation), (point[0] - x, point[1] - y, point[2] - z))
