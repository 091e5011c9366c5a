"""Convex hulls of meshes and points, also with few corners."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.mesh.geometry import Floats, Integers, Mesh, MeshMaterial, MeshPart, scaled_normals
from urdfkit.mesh.welding import finite

if TYPE_CHECKING:
    from manifold3d import Manifold

#: Most corners of a hull or convex piece, the limit of physics engines.
MOST_CORNERS = 64
#: Angles in degrees between the faces of a hull with few corners; the first sufficient one is used.
_ANGLES = (3, 6, 9, 12, 15, 20, 25, 30, 40, 50)
#: Volume, relative to the cube of the longest edge, below which a solid is flat.
_ROUNDING = 1e-14


class NoHull(UrdfkitError):
    """All points lie in a plane."""


def hull(mesh: Mesh) -> Mesh:
    """The convex hull of all parts, with the material of the first.

    Raises:
        NoHull: all points lie in a plane.
    """
    from manifold3d import Manifold

    points = mesh.vertices[np.unique(mesh.faces)]
    points = points[finite(points)]
    solid = Manifold.hull_points(points)
    if solid.is_empty() or not solid.volume() > _ROUNDING * np.ptp(points, axis=0).max() ** 3:
        raise NoHull("all points lie in a plane, so there is no convex hull")
    corners, faces = arrays_of(solid)
    return mesh._replace(parts=(MeshPart(corners, faces, _material(mesh)),))


def arrays_of(solid: Manifold) -> tuple[Floats, Integers]:
    """Vertices (n, 3) and triangles (m, 3) of a manifold3d solid."""
    mesh = solid.to_mesh64()
    vertices = np.array(mesh.vert_properties[:, :3], dtype=np.float64)  # a copy: read-only there
    return vertices, np.asarray(mesh.tri_verts, dtype=np.int64)


def with_few_corners(shell: Mesh) -> Mesh:
    """A convex solid of at most `MOST_CORNERS` corners that closely contains another one.

    Of faces with similar normals the largest is kept and moved outwards until all points lie behind
    it. Returns ``shell`` itself if that does not yield few enough corners.

    Args:
        shell: a convex hull.
    """
    from scipy.spatial import HalfspaceIntersection, QhullError

    points = shell.vertices
    if len(points) <= MOST_CORNERS:
        return shell
    size, middle = float(np.ptp(points, axis=0).max()), points.mean(axis=0)
    scaled = (points - middle) / size
    all_normals = _normals(scaled, shell.faces)
    for degrees in _ANGLES:
        normals = _spread_out(all_normals, degrees)
        reach = (normals @ scaled.T).max(axis=1)
        try:
            corners = HalfspaceIntersection(
                np.column_stack([normals, -reach]), np.zeros(3)
            ).intersections
        except QhullError:  # too flat: the intersection has no inside
            continue
        candidate = hull(points_only(corners * size + middle))
        if len(candidate.vertices) <= MOST_CORNERS:
            return shell._replace(parts=(candidate.parts[0]._replace(material=_material(shell)),))
    return shell


def half_spaces(corners: Floats) -> Floats:
    """(k, 4), outward unit normals and offsets of the convex hull of points (n, 3).

    Raises:
        scipy.spatial.QhullError: the hull has no inside.
    """
    from scipy.spatial import ConvexHull

    return np.unique(ConvexHull(corners).equations, axis=0)


def hull_corners(points: Floats) -> Floats:
    """The points that are corners of their convex hull."""
    from scipy.spatial import ConvexHull

    return np.asarray(points[ConvexHull(points).vertices])


def _normals(points: Floats, faces: Integers) -> Floats:
    """Unit normals of triangles, by decreasing area."""
    normals = scaled_normals(points[faces])
    lengths = np.linalg.norm(normals, axis=1)
    order = np.argsort(-lengths[lengths > 0], kind="stable")
    return np.asarray((normals[lengths > 0] / lengths[lengths > 0][:, None])[order])


def _spread_out(normals: Floats, degrees: float) -> Floats:
    """The normals that differ from all earlier ones by at least an angle."""
    chosen: list[Floats] = []
    while len(normals):
        chosen.append(normals[0])
        normals = normals[normals @ normals[0] < np.cos(np.radians(degrees))]
    return np.array(chosen)


def _material(mesh: Mesh) -> MeshMaterial | None:
    return mesh.parts[0].material if mesh.parts else None


def points_only(corners: Floats) -> Mesh:
    """A mesh of points without a surface, as input of `hull`."""
    return Mesh((MeshPart(corners, np.arange(len(corners)).reshape(1, -1)),))
