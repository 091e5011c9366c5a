"""Ray casting against the shapes of a robot: what a sensor on it measures of the robot itself.

Lengths in m, directions are unit vectors. Primitives are intersected in closed form; for meshes
see `urdfkit.mesh.ray_casting`.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from math import cos, inf, sin, sqrt

from urdfkit.core.record import Record
from urdfkit.core.spatial import Z_AXIS, Transform, Vector, dot, rotate
from urdfkit.robot.link import Body
from urdfkit.robot.shapes import Primitive, primitive

#: Direction components below this are 0: the ray is parallel to a face or an axis.
_PARALLEL = 1e-9
#: In m: a shape that ends as near to the scan plane touches it.
_TOUCHING = 1e-4


class Scan(Record):
    """The beams of a planar lidar, in its frame: x forwards, z normal to the scan plane."""

    #: first and last: directions of the outermost beams in rad, counter-clockwise from x.
    first: float
    last: float
    samples: int  # number of beams, at least 2
    #: low and high: range in m.
    low: float
    high: float

    @property
    def step(self) -> float:
        return (self.last - self.first) / (self.samples - 1)

    @property
    def directions(self) -> list[Vector]:
        angles = (self.first + number * self.step for number in range(self.samples))
        return [(cos(angle), sin(angle), 0.0) for angle in angles]


def shape_of(body: Body, at: Transform) -> Primitive | None:
    """A primitive in the frame of a sensor; None for a mesh or a shape without sizes.

    Args:
        at: the frame of its link in the frame of the sensor.
    """
    return primitive(body._replace(origin=at @ body.origin))


def intervals(
    shape: Primitive, directions: Iterable[Vector]
) -> Iterator[tuple[float, float] | None]:
    """Entry and exit distances of rays from the origin, negative behind it; None for a miss."""
    frame = shape.origin.inverse
    start = frame.position
    for direction in directions:
        yield _interval(shape, start, rotate(frame.rotation, direction))


def _interval(shape: Primitive, start: Vector, along: Vector) -> tuple[float, float] | None:
    """Distances at which a ray in the frame of a shape enters and leaves it."""
    if shape.kind == "box":
        halves = (shape.size[0] / 2, shape.size[1] / 2, shape.size[2] / 2)
        return _common(_slab(s, d, h) for s, d, h in zip(start, along, halves, strict=True))
    if shape.kind == "sphere":
        return _round(start, along, shape.radius)
    (x, y, z), (dx, dy, dz) = start, along
    ends = shape.radius if shape.kind == "capsule" else 0.0  # approximated by flat ends
    side = _round((x, y, 0.0), (dx, dy, 0.0), shape.radius)
    return _common((side, _slab(z, dz, shape.length / 2 + ends)))


def _slab(start: float, along: float, half: float) -> tuple[float, float] | None:
    if abs(along) < _PARALLEL:
        return (-inf, inf) if abs(start) <= half else None
    t1, t2 = (-half - start) / along, (half - start) / along
    return min(t1, t2), max(t1, t2)


def _round(start: Vector, along: Vector, radius: float) -> tuple[float, float] | None:
    """The interval in a ball; in an infinite cylinder if all z are 0."""
    square, middle = dot(along, along), dot(start, along)
    excess = dot(start, start) - radius * radius
    if square < _PARALLEL:
        return (-inf, inf) if excess <= 0 else None
    discriminant = middle * middle - square * excess
    if discriminant < 0:
        return None
    return (-middle - sqrt(discriminant)) / square, (-middle + sqrt(discriminant)) / square


def _common(parts: Iterable[tuple[float, float] | None]) -> tuple[float, float] | None:
    low, high = -inf, inf
    for part in parts:
        if part is None:
            return None
        low, high = max(low, part[0]), min(high, part[1])
    return (low, high) if low <= high else None


def crosses_plane(shape: Primitive) -> bool:
    """True if a shape is on both sides of the scan plane of the sensor in whose frame it is.

    Simulators do not agree on a beam along a face: a lidar that stands on the deck.
    """
    return shape.reach(Z_AXIS) > _TOUCHING and shape.reach((0.0, 0.0, -1.0)) > _TOUCHING


def beams_on(
    shape: Primitive, scan: Scan, directions: Sequence[Vector], *, sees_inside: bool
) -> Iterator[int]:
    """Indices of the beams that end at a primitive.

    Args:
        shape: in the frame of the sensor; it intersects the scan plane.
        sees_inside: True if a beam that starts inside the shape ends at the far surface, as in
            Gazebo Classic; rendering sensors see the outer surface only.
    """
    for number, interval in enumerate(intervals(shape, directions)):
        if interval is None:
            continue
        distance = interval[1] if sees_inside and interval[0] < scan.low else interval[0]
        if scan.low <= distance <= scan.high:
            yield number
