"""Convex pieces around a mesh: grown until they contain it; what sticks out, what is missing."""

from collections.abc import Sequence

import numpy as np

from urdfkit.mesh import solids
from urdfkit.mesh.convex_hull import half_spaces, hull_corners
from urdfkit.mesh.distance import one_way
from urdfkit.mesh.geometry import Flags, Floats, Integers, Mesh
from urdfkit.mesh.repair.soup import soup_of
from urdfkit.mesh.welding import weld

#: Edges to which triangles are cut where pieces meet, as a part of the diagonal of the surface.
_FINE = 0.01
#: What a piece may grow more than the corners of a triangle need, so that it is not cut; same unit.
_LITTLE = 0.0005
#: Triangles are cut in rounds, each edge in half; more than so many at once are not cut further.
_MAX_TRIANGLES = 50_000
#: A point outside by less, relative to the diagonal, is outside by rounding.
ROUNDING = 1e-9
#: Points that are compared with the faces of a piece at once.
_BLOCK = 20_000


def excess(points: Floats, planes: Floats) -> Floats:
    """(n,), the signed distance of points from the outermost of some planes.

    At most 0 inside of the half-spaces, and outside at most the distance from them.

    Args:
        points: (n, 3).
        planes: (k, 4), from `urdfkit.mesh.convex_hull.half_spaces`.
    """
    found = [
        (points[start : start + _BLOCK] @ planes[:, :3].T + planes[:, 3]).max(axis=1)
        for start in range(0, len(points), _BLOCK)
    ]
    return np.concatenate(found) if found else np.zeros(0)


def grown(pieces: Sequence[Floats], points: Floats, faces: Integers) -> list[Floats]:
    """The corners of convex pieces that contain a surface, each triangle whole in one of them.

    A triangle belongs to the piece that has to grow least for it, which is the one that it lies in,
    if any. Where that is more than each of its corners needs by itself, pieces meet within the
    triangle, and it is cut.

    Args:
        pieces: (n, 3) each, corners of convex pieces that have an inside.
        points: (n, 3), of the surface.
        faces: (m, 3), its triangles.
    """
    found = list(pieces)
    size = float(np.linalg.norm(np.ptp(points[faces].reshape(-1, 3), axis=0)))
    while found and len(faces):
        outside = np.stack([excess(points, half_spaces(corners)) for corners in found])[:, faces]
        needed = outside.max(axis=2)
        least, owner = needed.min(axis=0), needed.argmin(axis=0)
        is_whole = least <= np.maximum(outside.min(axis=0).max(axis=1), 0.0) + _LITTLE * size
        triangles = points[faces]
        edges = np.linalg.norm(triangles - np.roll(triangles, 1, axis=1), axis=2).max(axis=1)
        is_whole |= edges <= _FINE * size
        if 4 * np.count_nonzero(~is_whole) > _MAX_TRIANGLES:
            is_whole[:] = True
        for number, corners in enumerate(found):
            own = faces[is_whole & (owner == number) & (least > ROUNDING * size)]
            if len(own):
                found[number] = hull_corners(np.concatenate([corners, points[np.unique(own)]]))
        points, faces = _halved(triangles[~is_whole])
    return found


def _halved(triangles: Floats) -> tuple[Floats, Integers]:
    """Points and faces of triangles (m, 3, 3), each cut into four at the middles of its edges."""
    a, b, c = triangles.swapaxes(0, 1)
    ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
    corners = [a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca]
    points = np.stack(corners, axis=1).reshape(-1, 3)
    return weld(points, np.arange(len(points)).reshape(-1, 3))


def missing(pieces: Mesh, mesh: Mesh) -> float:
    """How far the surface of a mesh lies outside of convex pieces, at most, in its unit.

    Args:
        pieces: each part a convex solid.
        mesh: any with triangles.
    """
    planes = [half_spaces(part.vertices) for part in pieces.parts]
    surface = soup_of(mesh)
    size = surface.size

    def are_outside(points: Floats) -> Flags:
        least = np.min([excess(points, one) for one in planes], axis=0)
        return np.asarray(least > ROUNDING * size)

    return one_way(surface.points, surface.faces, pieces.vertices, pieces.faces, are_outside)


def protrusion(pieces: Mesh, mesh: Mesh) -> float:
    """How far solids stick out of a mesh, at most, in its unit.

    Args:
        pieces: each part a solid; they may overlap.
        mesh: any with triangles.
    """
    # Where pieces meet, their faces lie deep in the mesh, and stick out of nothing.
    outside = solids.beyond(pieces, mesh) if len(pieces.parts) > 1 else pieces
    if not len(outside.faces):
        return 0.0
    surface = soup_of(mesh)
    return one_way(outside.vertices, outside.faces, surface.points, surface.faces)
