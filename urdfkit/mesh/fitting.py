"""Simple shapes around a mesh: sphere, box, cylinder, hull, convex pieces, each with its error.

The shapes contain the mesh, so that nothing collides later than it should; their error is how far
they stick out: the greatest distance from a point of theirs to the surface of the mesh. What is
missing all the same is measured, too.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Transform, Vector, basis, vector
from urdfkit.mesh import solids
from urdfkit.mesh.containment import missing, protrusion
from urdfkit.mesh.convex_decomposition import cut
from urdfkit.mesh.convex_hull import NoHull, hull, with_few_corners
from urdfkit.mesh.geometry import Floats, Mesh
from urdfkit.mesh.transforms import moved

#: In the unit of the mesh; below it, the search for the smallest ball fails.
_SMALLEST = 1e-6
#: A box along the axes is taken if it is larger than the smallest one by no more than this.
_ALONG_AXES = 1.03
#: A wheel: the cosine between the axes, their distance as a part of the radius, and the part of the
#: circle around it that its outline fills.
_ALONG, _OFF_AXIS, _ROUND = 0.99, 0.1, 0.95
#: Convex pieces that may do where more of them are within the bound.
_FEW = (2, 4)
#: Where nothing is within the bound, a simpler shape is taken if it is worse by no more than this.
_HARDLY_WORSE = 1.25


class Fit(Record):
    """A primitive shape fitted around a mesh."""

    kind: str  # ``sphere``, ``box``, ``cylinder``, ``hull`` or ``pieces``
    #: Of a box its edges; of a sphere its radius, 0, 0; of a cylinder radius, length, 0.
    size: Vector
    frame: Transform  # of the shape, in that of the mesh
    mesh: Mesh  # its surface, in the frame of the mesh; of ``pieces`` each is a part
    error: float  # how far it sticks out, in the unit of the mesh
    missing: float  # how far the mesh sticks out of it, in its unit

    def __str__(self) -> str:
        return f"{len(self.mesh.parts)} pieces" if self.kind == "pieces" else self.kind


class Fits(Record):
    """The shapes that were tried."""

    best: Fit  # the simplest within the bound, else the simplest of those with a small error
    tried: tuple[Fit, ...]  # all of them, the simpler ones first
    within: bool  # True if the best one is within the bound
    why: str = ""  # another reason to take the best one; empty for none


def rolling(fits: Fits, mesh: Mesh, axis: Vector, through: Vector) -> Fits:
    """The cylinder, for what turns about it and is round: hubs and grooves do not touch the ground.

    Args:
        axis: that it turns about; a unit vector.
    """
    from scipy.spatial import ConvexHull

    cylinder = next(one for one in fits.tried if one.kind == "cylinder")
    radius = cylinder.size[0]
    rows = np.array(basis(axis))
    offset = np.subtract(cylinder.frame.position, through)
    offset_norm = float(np.linalg.norm((rows @ offset)[:2]))
    along = abs(float(np.dot(axis, [row[2] for row in cylinder.frame.rotation])))
    if along < _ALONG or offset_norm > _OFF_AXIS * radius:
        return fits
    seen = mesh.vertices @ rows.T
    if ConvexHull(seen[:, :2]).volume < _ROUND * np.pi * radius**2:
        return fits
    return fits._replace(best=cylinder, why="it is round and turns about its axis")


def fit(mesh: Mesh, bound: float, *, most: int = 8) -> Fits:
    """The best simple shape around a mesh.

    Primitives come before the hull, the hull before convex pieces, and few of these before many:
    that is what they cost a physics engine. Of the primitives within the bound that with the
    smallest error is taken.

    Args:
        mesh: with at least one triangle.
        bound: of the error, in the unit of the mesh.
        most: convex pieces at most.

    Raises:
        NoHull: all points of the mesh lie in a plane, or it is too small to be a part.
    """
    shell = hull(mesh)
    points = shell.vertices
    if np.ptp(points, axis=0).max() < _SMALLEST:
        raise NoHull("it is too small for a shape around it")
    tried = [
        _measured_fit(mesh, *one) for one in (_box(points), _cylinder(points), _sphere(points))
    ]
    good = [one for one in tried if one.error <= bound]
    if not good:
        for one in _meshes(mesh, shell, bound, most):
            tried.append(one)
            good = [one for one in tried if one.error <= bound]
            if good:
                break
    if good:
        return Fits(min(good, key=lambda one: one.error), tuple(tried), within=True)
    enough = _HARDLY_WORSE * min(one.error for one in tried)
    best = next(one for one in tried if one.error <= enough)
    return Fits(best, tuple(tried), within=False)


def _meshes(mesh: Mesh, shell: Mesh, bound: float, most: int) -> Iterator[Fit]:
    lean = _measured_fit(mesh, "hull", _NO_SIZE, Transform(), with_few_corners(shell))
    yield lean if lean.error <= bound else _measured_fit(mesh, "hull", _NO_SIZE, Transform(), shell)
    if most > 1:
        many = _in_pieces(mesh, most)
        if many.error <= bound:  # else fewer will not do either
            yield from (_in_pieces(mesh, number) for number in _FEW if number < most)
        yield many


def _in_pieces(mesh: Mesh, most: int) -> Fit:
    return _measured_fit(mesh, "pieces", _NO_SIZE, Transform(), cut(mesh, most=most))


_NO_SIZE: Vector = (0.0, 0.0, 0.0)


def _measured_fit(mesh: Mesh, kind: str, size: Vector, frame: Transform, shape: Mesh) -> Fit:
    placed = moved(shape, frame)
    # Primitives are made around all points; their meshes have flat sides.
    lost = missing(placed, mesh) if kind in ("hull", "pieces") else 0.0
    return Fit(kind, size, frame, placed, protrusion(placed, mesh), lost)


_Shape = tuple[str, Vector, Transform, Mesh]


def _box(points: Floats) -> _Shape:
    """The smallest box, or the one along the axes if that is hardly larger."""
    from trimesh.bounds import oriented_bounds

    low, high = points.min(axis=0), points.max(axis=0)
    edges, frame = high - low, Transform(position=vector((low + high) / 2))
    to_box, extents = oriented_bounds(points)
    if np.prod(edges) > _ALONG_AXES * np.prod(extents):
        from_box = np.linalg.inv(to_box)
        edges, frame = extents, Transform(_rows(from_box[:3, :3]), vector(from_box[:3, 3]))
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
        seen = points @ rows.T
        center, _ = minimum_nsphere(seen[:, :2])
        radius = np.linalg.norm(seen[:, :2] - center, axis=1).max()  # that found is a guess
        low, high = seen[:, 2].min(), seen[:, 2].max()
        volume = float(np.pi * radius**2 * (high - low))
        if best is None or volume < 0.999 * best[0]:
            middle = rows.T @ np.array([*center, (low + high) / 2])
            frame = Transform(_rows(rows.T), vector(middle))
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


def _rows(matrix: Floats) -> Rotation:
    a, b, c = (vector(row) for row in matrix)
    return (a, b, c)
