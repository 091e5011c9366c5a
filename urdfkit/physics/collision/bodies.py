"""The collision bodies of a model with bounds, without any library. Lengths in m."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import dist, hypot

from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Transform, Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.link import Body, Shape

if TYPE_CHECKING:
    from urdfkit.mesh.measures import Measures
    from urdfkit.robot import Robot

#: Limit in m of the size of bodies and their distance from the link; others are omitted.
MAX_COORDINATE = 1e6
#: Least thickness in m: thinner primitives are thickened, smaller meshes omitted.
THINNEST = 1e-6
#: Overlap in m up to which bodies only touch.
TOUCH = 1e-5
#: Relative difference of a mesh's volume from its hull's up to which it is convex.
_CONVEX = 1e-4


class CollisionBody(Record):
    """One ``<collision>`` with its bounding box."""

    link: str  # name of its link
    number: int  # index among the collisions of the link
    origin: Transform  # frame of the body in the link
    kind: str  # ``box``, ``sphere``, ``cylinder``, ``capsule`` or ``mesh``
    size: tuple[float, ...]  # three sides; radius; radius and length; empty for a mesh
    center: Vector  # of the bounding box along the axes of the body, in its frame
    half: Vector  # half sides of the bounding box
    #: Corners of the bounding box, or extreme vertices of a mesh, which are inside a convex body if
    #: this body is. Empty for a mesh without measures.
    points: tuple[Vector, ...]
    may_be_convex: bool  # False for a mesh that is not convex

    @property
    def radius(self) -> float:
        """Radius of the bounding sphere about the centre; of a mesh, around its points."""
        if self.kind == "mesh" and self.points:
            return max(dist(self.center, point) for point in self.points)
        return bounding_radius(self.kind, self.half)

    @property
    def thickness(self) -> float:
        """The shortest side of the bounding box."""
        return 2 * min(self.half)


def collision_bodies(robot: Robot, *, unit: bool) -> Iterator[CollisionBody]:
    """The usable collision bodies of a robot.

    Args:
        unit: apply the unit of COLLADA files.
    """
    for link in robot.model.links_by_name.values():
        for number, body in enumerate(link.collisions):
            if body.shape is None or why_omitted(body):
                continue
            if body.shape.kind != "mesh":
                yield _primitive(link.name, number, body)
            elif robot.files.path(body.shape) is not None:
                yield _mesh(link.name, number, body, robot.measures(body.shape), unit=unit)


def why_omitted(body: Body) -> str:
    """The reason why a collision is omitted, regardless of its mesh file; otherwise empty."""
    shape = body.shape
    if shape is None:
        return "it has no geometry"
    if max(map(abs, body.origin.position)) > MAX_COORDINATE:
        return f"it is more than {MAX_COORDINATE:g} m from its link"
    if shape.kind == "mesh":
        return ""
    sizes = _sizes(shape)
    if sizes is None:
        return f"<{shape.kind}> is not a URDF shape"
    if not sizes or None in sizes:
        return "a size is missing or cannot be read"
    size = primitive_size(shape)
    if min(value for value in sizes if value is not None) < 0:
        return "a size is negative"
    if max(size) > MAX_COORDINATE:
        return f"it is larger than {MAX_COORDINATE:g} m"
    return ""


def primitive_size(shape: Shape) -> tuple[float, ...]:
    """Three sides; radius; or radius and length: at least `THINNEST`."""
    return tuple(max(value, THINNEST) for value in _sizes(shape) or () if value is not None)


def half_edges(kind: str, size: tuple[float, ...]) -> Vector:
    """Half sides of the bounding box of a primitive."""
    if kind == "box":
        return (size[0] / 2, size[1] / 2, size[2] / 2)
    above = size[0] if kind == "sphere" else size[1] / 2
    return (size[0], size[0], above + size[0] if kind == "capsule" else above)


def bounding_radius(kind: str, half: Vector) -> float:
    """Radius of the bounding sphere of a body, from the half sides of its bounding box."""
    if kind in ("sphere", "capsule"):
        return half[2]
    return hypot(half[0], half[2]) if kind == "cylinder" else hypot(*half)


def _sizes(shape: Shape) -> tuple[float | None, ...] | None:
    """The sizes as written; None for a shape that is not a primitive."""
    if shape.kind == "box":
        return shape.size or ()
    if shape.kind == "sphere":
        return (shape.radius,)
    if shape.kind in ("cylinder", "capsule"):
        return (shape.radius, shape.length)
    return None


def _primitive(link: str, number: int, body: Body) -> CollisionBody:
    assert body.shape is not None
    kind, size = body.shape.kind, primitive_size(body.shape)
    half = half_edges(kind, size)
    x, y, z = ((-edge, edge) for edge in half)
    corners = tuple(product(x, y, z))
    return CollisionBody(
        link, number, body.origin, kind, size, ORIGIN, half, corners, may_be_convex=True
    )


def _mesh(
    link: str, number: int, body: Body, measures: Measures | str, *, unit: bool
) -> CollisionBody:
    """A mesh with its measured bounding box; without measures, with the largest possible box."""
    assert body.shape is not None
    if isinstance(measures, str):
        half = (MAX_COORDINATE, MAX_COORDINATE, MAX_COORDINATE)
        return CollisionBody(
            link, number, body.origin, "mesh", (), ORIGIN, half, (), may_be_convex=True
        )
    factor = measures.unit if unit else 1.0
    a, b, c = (scale * factor for scale in body.shape.scale)
    low, high = ((a * x, b * y, c * z) for x, y, z in (measures.low, measures.high))
    center = ((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, (low[2] + high[2]) / 2)
    half = (abs(high[0] - low[0]) / 2, abs(high[1] - low[1]) / 2, abs(high[2] - low[2]) / 2)
    points = tuple((a * x, b * y, c * z) for x, y, z in measures.points)
    return CollisionBody(
        link, number, body.origin, "mesh", (), center, half, points, _may_be_convex(measures)
    )


def _may_be_convex(measures: Measures) -> bool:
    """False for a closed surface with less volume than its hull."""
    solid, hull = measures.solid, measures.hull
    if solid is None or hull is None:
        return True
    return abs(hull.volume - solid.volume) <= _CONVEX * solid.volume
