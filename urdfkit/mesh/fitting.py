"""Simple shapes around a mesh: sphere, box, cylinder, hull, convex pieces, each with its error.

The shapes contain the mesh, so that no collision is detected late. Their error is how far they
protrude: the greatest distance from a point of the shape to the surface of the mesh. The part of
the mesh that a shape does not contain is measured, too.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform, Vector, basis, rotation, vector
from urdfkit.mesh import solids
from urdfkit.mesh.containment import missing, protrusion
from urdfkit.mesh.convex_decomposition import cut
from urdfkit.mesh.convex_hull import NoHull, hull, with_few_corners
from urdfkit.mesh.geometry import Floats, Mesh
from urdfkit.mesh.transforms import moved

#: Size, in the unit of the mesh, below which the search for the smallest ball fails.
_MIN_SIZE = 1e-6
#: A box along the axes is chosen if its volume exceeds the smallest box's by no more than this.
_ALONG_AXES = 1.03
#: A wheel: least cosine between the axes, greatest distance between them as a part of the radius,
#: and least part of its circumscribed circle that its outline fills.
_MIN_COSINE, _OFF_AXIS, _ROUND = 0.99, 0.1, 0.95
#: Smaller numbers of convex pieces to try if the largest number is within the bound.
_FEWER_PIECES = (2, 4)
#: If no shape is within the bound, a simpler shape is chosen if its error is larger by no more.
_HARDLY_WORSE = 1.25


class Fit(Record):
    """A primitive shape fitted around a mesh."""

    kind: str  # ``sphere``, ``box``, ``cylinder``, ``hull`` or ``pieces``
    #: Box: edge lengths; sphere: radius, 0, 0; cylinder: radius, length, 0.
    size: Vector
    frame: Transform  # of the shape, in the frame of the mesh
    mesh: Mesh  # surface of the shape, in the frame of the mesh; each of ``pieces`` is a part
    error: float  # how far the shape protrudes from the mesh, in the unit of the mesh
    missing: float  # how far the mesh protrudes from the shape, in the unit of the mesh

    def __str__(self) -> str:
        return f"{len(self.mesh.parts)} pieces" if self.kind == "pieces" else self.kind


class Fits(Record):
    """The candidate shapes."""

    best: Fit  # the simplest within the bound, else the simplest with a small error
    tried: tuple[Fit, ...]  # all candidates, simpler ones first
    within: bool  # True if the best candidate is within the bound
    why: str = ""  # another reason for the choice; may be empty


def rolling(fits: Fits, mesh: Mesh, axis: Vector, through: Vector) -> Fits:
    """Prefer the cylinder if the mesh is round and rotates about it, as a wheel does.

    Hubs and grooves, which make its error large, do not touch the ground.

    Args:
        axis: the axis of rotation, a unit vector.
        through: a point on the axis.
    """
    from scipy.spatial import ConvexHull

    cylinder = next(fit for fit in fits.tried if fit.kind == "cylinder")
    radius = cylinder.size[0]
    rows = np.array(basis(axis))
    offset = np.subtract(cylinder.frame.position, through)
    offset_norm = float(np.linalg.norm((rows @ offset)[:2]))
    along = abs(float(np.dot(axis, [row[2] for row in cylinder.frame.rotation])))
    if along < _MIN_COSINE or offset_norm > _OFF_AXIS * radius:
        return fits
    projected = mesh.vertices @ rows.T
    if ConvexHull(projected[:, :2]).volume < _ROUND * np.pi * radius**2:
        return fits
    return fits._replace(best=cylinder, why="it is round and turns about its axis")


def fit(mesh: Mesh, bound: float, *, most: int = 8) -> Fits:
    """The best simple shape around a mesh.

    Primitives are preferred to the hull, the hull to convex pieces, and few pieces to many: in this
    order they cost a physics engine more. Of the primitives within the bound, the one with the
    smallest error is chosen.

    Args:
        mesh: with at least one triangle.
        bound: greatest error, in the unit of the mesh.
        most: greatest number of convex pieces.

    Raises:
        NoHull: all points of the mesh lie in a plane, or it is too small to be a part.
    """
    shell = hull(mesh)
    points = shell.vertices
    if np.ptp(points, axis=0).max() < _MIN_SIZE:
        raise NoHull("it is too small for a shape around it")
    shapes = (_box(points), _cylinder(points), _sphere(points))
    fits = [_measured_fit(mesh, *shape) for shape in shapes]
    good = [fit for fit in fits if fit.error <= bound]
    if not good:
        for candidate in _meshes(mesh, shell, bound, most):
            fits.append(candidate)
            if candidate.error <= bound:
                good = [candidate]
                break
    if good:
        return Fits(min(good, key=lambda fit: fit.error), tuple(fits), within=True)
    enough = _HARDLY_WORSE * min(fit.error for fit in fits)
    best = next(fit for fit in fits if fit.error <= enough)
    return Fits(best, tuple(fits), within=False)


def _meshes(mesh: Mesh, shell: Mesh, bound: float, most: int) -> Iterator[Fit]:
    # Of all points of the mesh, those of its hull stick out farthest of a convex shape.
    lean = _measured_fit(mesh, "hull", _NO_SIZE, Transform(), with_few_corners(shell), shell)
    if lean.error <= bound:
        yield lean
    else:
        yield _measured_fit(mesh, "hull", _NO_SIZE, Transform(), shell, shell)
    if most > 1:
        many = _in_pieces(mesh, most)
        if many.error <= bound:  # otherwise fewer pieces are not sufficient either
            yield from (_in_pieces(mesh, number) for number in _FEWER_PIECES if number < most)
        yield many


def _in_pieces(mesh: Mesh, most: int) -> Fit:
    return _measured_fit(mesh, "pieces", _NO_SIZE, Transform(), cut(mesh, most=most), mesh)


_NO_SIZE: Vector = (0.0, 0.0, 0.0)


def _measured_fit(
    mesh: Mesh,
    kind: str,
    size: Vector,
    frame: Transform,
    shape: Mesh,
    contained: Mesh | None = None,
) -> Fit:
    """A shape with its errors.

    Args:
        contained: the part of the mesh that may stick out; without it, nothing does: primitives
            contain all points, and only their meshes, with flat sides, do not.
    """
    placed = moved(shape, frame)
    lost = missing(placed, contained) if contained else 0.0
    return Fit(kind, size, frame, placed, protrusion(placed, mesh), lost)


_Shape = tuple[str, Vector, Transform, Mesh]


def _box(points: Floats) -> _Shape:
    """The smallest box, or the box along the axes if it is hardly larger."""
    from trimesh.bounds import oriented_bounds

    low, high = points.min(axis=0), points.max(axis=0)
    edges, frame = high - low, Transform(position=vector((low + high) / 2))
    to_box, extents = oriented_bounds(points)
    if np.prod(edges) > _ALONG_AXES * np.prod(extents):
        from_box = np.linalg.inv(to_box)
        edges, frame = extents, Transform(rotation(from_box[:3, :3]), vector(from_box[:3, 3]))
    size = vector(edges)
    return "box", size, frame, solids.as_mesh(solids.box(size))


def _cylinder(points: Floats) -> _Shape:
    """The smallest cylinder along an axis of the mesh or of its smallest box."""
    from trimesh.bounds import oriented_bounds
    from trimesh.nsphere import minimum_nsphere

    to_box, _ = oriented_bounds(points)
    best: tuple[float, float, float, Transform] | None = None
    for axis in (*np.eye(3), *to_box[:3, :3]):
        rows = np.array(basis(vector(axis)))
        projected = points @ rows.T
        center, _ = minimum_nsphere(projected[:, :2])
        radius = np.linalg.norm(projected[:, :2] - center, axis=1).max()  # exact
        low, high = projected[:, 2].min(), projected[:, 2].max()
        volume = float(np.pi * radius**2 * (high - low))
        if best is None or volume < 0.999 * best[0]:
            middle = rows.T @ np.array([*center, (low + high) / 2])
            frame = Transform(rotation(rows.T), vector(middle))
            best = (volume, float(radius), float(high - low), frame)
    assert best is not None
    _, radius, length, frame = best
    shape = solids.cylinder(radius, -length / 2, length / 2)
    return "cylinder", (radius, length, 0.0), frame, solids.as_mesh(shape)


def _sphere(points: Floats) -> _Shape:
    from trimesh.nsphere import minimum_nsphere

    center, _ = minimum_nsphere(points)
    radius = np.linalg.norm(points - center, axis=1).max()
    shape = solids.as_mesh(solids.ball(float(radius)))
    return "sphere", (float(radius), 0.0, 0.0), Transform(position=vector(center)), shape
