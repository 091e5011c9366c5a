"""The collision bodies of a model with bounds, without any library. Lengths in m."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from math import dist, hypot

from urdfkit.core.record import Record
from urdfkit.core.spatial import ORIGIN, Transform, Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.model import Body, Shape

if TYPE_CHECKING:
    from urdfkit.mesh.measures import Measures
    from urdfkit.robot import Robot

#: In m: bodies that are larger, or farther from their link, are left out.
LARGEST = 1e6
#: In m: thinner primitives are made so thick, and smaller meshes left out.
THINNEST = 1e-6
#: Bodies that overlap by no more than this, in m, touch.
TOUCH = 1e-5
#: A mesh is not convex if its volume differs more from that of its hull, relatively.
_CONVEX = 1e-4


class CollisionBody(Record):
    """One ``<collision>`` with its bounding box."""

    link: str  # name of its link
    number: int  # of the element among the collisions of the link, from 0
    origin: Transform  # its frame in that of the link
    kind: str  # ``box``, ``sphere``, ``cylinder``, ``capsule`` or ``mesh``
    size: tuple[float, ...]  # three sides; radius; radius and length; nothing for a mesh
    center: Vector  # of the bounding box along its own axes, in its frame
    half: Vector  # half the sides of that box
    #: The corners of that box, or extreme vertices of a mesh: what lies in the inside of a convex
    #: body has them there. Empty for a mesh that is not measured.
    points: tuple[Vector, ...]
    may_be_convex: bool  # False for a mesh that is known not to be

    @property
    def radius(self) -> float:
        """Radius of a sphere about the centre that holds the body, or the points of a mesh."""
        if self.kind == "mesh" and self.points:
            return max(dist(self.center, point) for point in self.points)
        return bounding_radius(self.kind, self.half)

    @property
    def thickness(self) -> float:
        """The shortest side of the bounding box."""
        return 2 * min(self.half)

    def box(self, link: Transform) -> Transform:
        """The frame of the bounding box about its centre, given the frame of the link."""
        frame = link @ self.origin
        return Transform(frame.rotation, frame.apply(self.center))


def collision_bodies(robot: Robot, *, unit: bool) -> Iterator[CollisionBody]:
    """The collision bodies of a robot that can be used.

    Args:
        unit: apply the unit that a COLLADA file states.
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
    """Why a collision takes no part, as far as its mesh does not say; empty if it takes part."""
    shape = body.shape
    if shape is None:
        return "it has no geometry"
    if max(map(abs, body.origin.position)) > LARGEST:
        return f"it is more than {LARGEST:g} m from its link"
    if shape.kind == "mesh":
        return ""
    sizes = _sizes(shape)
    if sizes is None:
        return f"<{shape.kind}> is no shape of URDF"
    if not sizes or None in sizes:
        return "a size is missing or cannot be read"
    size = primitive_size(shape)
    if min(value for value in sizes if value is not None) < 0:
        return "a size is negative"
    if max(size) > LARGEST:
        return f"it is larger than {LARGEST:g} m"
    return ""


def primitive_size(shape: Shape) -> tuple[float, ...]:
    """Three sides; radius; or radius and length: what is thinner is made `THINNEST`."""
    return tuple(max(value, THINNEST) for value in _sizes(shape) or () if value is not None)


def half_edges(kind: str, size: tuple[float, ...]) -> Vector:
    """Half the sides of the box around a primitive."""
    if kind == "box":
        return (size[0] / 2, size[1] / 2, size[2] / 2)
    above = size[0] if kind == "sphere" else size[1] / 2
    return (size[0], size[0], above + size[0] if kind == "capsule" else above)


def bounding_radius(kind: str, half: Vector) -> float:
    """Radius of the sphere around a body, given half the sides of its bounding box."""
    if kind in ("sphere", "capsule"):
        return half[2]
    return hypot(half[0], half[2]) if kind == "cylinder" else hypot(*half)


def _sizes(shape: Shape) -> tuple[float | None, ...] | None:
    """The sizes as they are written; None for a shape that is not a primitive."""
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
    """A mesh with the bounding box that was measured, else with the largest one possible."""
    assert body.shape is not None
    if isinstance(measures, str):
        half = (LARGEST, LARGEST, LARGEST)
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
    """False for a closed surface whose hull encloses more."""
    solid, hull = measures.solid, measures.hull
    if solid is None or hull is None:
        return True
    return abs(hull.volume - solid.volume) <= _CONVEX * solid.volume
