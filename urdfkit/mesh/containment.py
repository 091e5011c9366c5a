"""Convex pieces around a mesh: grown to contain it, and how far each protrudes from the other."""

from collections.abc import Sequence

import numpy as np

from urdfkit.mesh import solids
from urdfkit.mesh.convex_hull import half_spaces, hull_corners
from urdfkit.mesh.distance import directed_distance
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.repair.soup import soup_of
from urdfkit.mesh.welding import weld

#: Edge length to which triangles are cut where pieces meet, as a part of the surface's diagonal.
_MAX_EDGE = 0.01
#: Growth of a piece beyond what the corners of a triangle need, up to which the triangle is not
#: cut; same unit.
_MAX_GROWTH = 0.0005
#: Most triangles at once; each round cuts every edge in half.
_MAX_TRIANGLES = 50_000
#: Rounding error of a distance, relative to the diagonal.
ROUNDING = 1e-9
#: Distances of points from faces of a piece that are computed at once: 80 MB.
_BLOCK = 10_000_000


def excess(points: Floats, planes: Floats) -> Floats:
    """(n,), signed distances of points from the planes, the greatest over all planes.

    At most 0 inside of the half-spaces; outside, at most the distance from their intersection.

    Args:
        points: (n, 3).
        planes: (k, 4), from `urdfkit.mesh.convex_hull.half_spaces`.
    """
    block = max(1, _BLOCK // max(1, len(planes)))
    distances = [
        (points[start : start + block] @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        for start in range(0, len(points), block)
    ]
    return np.concatenate(distances) if distances else np.zeros(0)


def grow_pieces(pieces: Sequence[Floats], points: Floats, faces: Integers) -> list[Floats]:
    """Corners of convex pieces, grown until each triangle of a surface lies in one of them.

    A triangle belongs to the piece that has to grow least for it, which is the piece that contains
    it, if any. If it has to grow more than for any single corner, pieces meet within the triangle,
    which is then cut.

    Args:
        pieces: (n, 3) each, corners of convex pieces that have an inside.
        points: (n, 3), of the surface.
        faces: (m, 3), triangles of the surface.
    """
    grown = list(pieces)
    size = float(np.linalg.norm(np.ptp(points[faces].reshape(-1, 3), axis=0)))
    while grown and len(faces):
        outside = np.stack([excess(points, half_spaces(corners)) for corners in grown])[:, faces]
        needed = outside.max(axis=2)
        least, owner = needed.min(axis=0), needed.argmin(axis=0)
        is_whole = least <= np.maximum(outside.min(axis=0).max(axis=1), 0.0) + _MAX_GROWTH * size
        triangles = points[faces]
        edges = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
        is_whole |= edges <= _MAX_EDGE * size
        if 4 * np.count_nonzero(~is_whole) > _MAX_TRIANGLES:
            is_whole[:] = True
        for number, corners in enumerate(grown):
            own = faces[is_whole & (owner == number) & (least > ROUNDING * size)]
            if len(own):
                grown[number] = hull_corners(np.concatenate([corners, points[np.unique(own)]]))
        points, faces = _halved(triangles[~is_whole])
    return grown


def _halved(triangles: Floats) -> tuple[Floats, Integers]:
    """Points and faces of triangles (m, 3, 3), each cut into four at its edge midpoints."""
    a, b, c = triangles.swapaxes(0, 1)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    corners = [a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]
    points = np.stack(corners, axis=1).reshape(-1, 3)
    return weld(points, np.arange(len(points)).reshape(-1, 3))


def missing(pieces: Mesh, mesh: Mesh) -> float:
    """Greatest distance of the surface of a mesh outside of convex pieces, in the mesh's unit.

    Args:
        pieces: each part a convex solid.
        mesh: with triangles.
    """
    planes = [half_spaces(part.vertices) for part in pieces.parts]
    soup = soup_of(mesh)
    size = soup.size

    def are_outside(points: Floats) -> Flags:
        outside = np.arange(len(points))
        for piece in planes:
            outside = outside[excess(points[outside], piece) > ROUNDING * size]
        flags = np.zeros(len(points), dtype=bool)
        flags[outside] = True
        return flags

    return directed_distance(soup.points, soup.faces, pieces.vertices, pieces.faces, are_outside)


def protrusion(pieces: Mesh, mesh: Mesh) -> float:
    """Greatest distance by which solids protrude from a mesh, in the mesh's unit.

    Args:
        pieces: each part a solid; they may overlap.
        mesh: with triangles.
    """
    # Where pieces meet, their faces lie deep in the mesh and do not protrude.
    outside = solids.subtract_mesh(pieces, mesh) if len(pieces.parts) > 1 else pieces
    if not len(outside.faces):
        return 0.0
    surface = soup_of(mesh)
    return directed_distance(outside.vertices, outside.faces, surface.points, surface.faces)
