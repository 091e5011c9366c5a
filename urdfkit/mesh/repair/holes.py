"""Closing of holes with triangles of least area."""

from collections.abc import Iterator
from itertools import pairwise

import numpy as np

from urdfkit.core.spatial import basis, vector
from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.mesh.repair.soup import TriangleSoup

#: Longer boundaries are closed in their plane: the optimal triangulation takes cubic time.
_MAX_CORNERS = 120


def fill(soup: TriangleSoup) -> TriangleSoup:
    """Close all holes."""
    faces: list[Integers] = []
    parts: list[int] = []
    existing = set(map(tuple, np.sort(soup.faces, axis=1).tolist()))
    used_edges = set(map(tuple, Edges(soup.faces).ends.tolist()))
    for loop, part in _loops(soup):
        triangles = triangulated(soup.points[loop], _barred(loop, used_edges))
        new = [row for row in loop[triangles].tolist() if tuple(sorted(row)) not in existing]
        faces.append(np.array(new, dtype=np.int64).reshape(-1, 3))
        parts += [part] * len(new)
    if not parts:
        return soup
    return soup.with_faces(np.concatenate(faces), np.array(parts, dtype=np.int64))


#: For each point, the next points of boundaries, each with the part of the adjacent face.
_Boundaries = dict[int, list[tuple[int, int]]]


def _loops(soup: TriangleSoup) -> Iterator[tuple[Integers, int]]:
    """Boundary loops, each as points in the direction of the filling faces, and a part."""
    edges = Edges(soup.faces)
    rows, sides = np.nonzero(edges.is_open[edges.of_face])
    following: _Boundaries = {}
    for face, side in zip(rows.tolist(), sides.tolist(), strict=True):
        start, end = int(soup.faces[face, side]), int(soup.faces[face, (side + 1) % 3])
        following.setdefault(end, []).append((start, int(soup.parts[face])))
    while following:
        loop, part = _walk(following)
        if len(loop) >= 3:
            yield np.array(loop, dtype=np.int64), part


def _walk(following: _Boundaries) -> tuple[list[int], int]:
    """Remove one loop from the boundaries; empty if the boundary is not closed.

    Where loops touch in a point, the walk returns to the point and cuts off one loop.
    """
    current = next(iter(following))
    path, places, part = [current], {current: 0}, 0
    while current in following:
        current, part = following[current].pop()
        if not following[path[-1]]:
            del following[path[-1]]
        if current in places:
            first = places[current]
            # The path before this loop is put back.
            for start, end in pairwise(path[: first + 1]):
                following.setdefault(start, []).append((end, part))
            return path[first:], part
        places[current] = len(path)
        path.append(current)
    return [], 0


def _barred(loop: Integers, used_edges: set[tuple[int, int]]) -> Flags:
    """(n, n), True for diagonals of a loop that are edges of the mesh already."""
    number = len(loop)
    barred = np.zeros((number, number), dtype=bool)
    if number > _MAX_CORNERS:
        return barred
    for start in range(number):
        for end in range(start + 2, number - (start == 0)):
            a, b = int(loop[start]), int(loop[end])
            barred[start, end] = ((a, b) if a < b else (b, a)) in used_edges
    return barred


def triangulated(points: Floats, barred: Flags) -> Integers:
    """Triangulation of a closed polyline in its direction, as (k, 3) indices of points.

    Args:
        points: (n, 3).
        barred: (n, n), forbidden diagonals, by start and end.
    """
    if len(points) > _MAX_CORNERS:
        return _in_plane(points)
    return _smallest(points, barred)


def _smallest(points: Floats, barred: Flags) -> Integers:
    """The triangulation of least area, which for a flat hole has no folds.

    A diagonal that is an existing edge would fold the fill back onto the surface, so it costs a
    thousand times the extent squared.

    Source: G. Barequet, M. Sharir, "Filling gaps in the boundary of a polyhedron", Computer Aided
    Geometric Design 12 (1995): dynamic programming over sections of the polyline.
    """
    number = len(points)
    extent = points.max(axis=0) - points.min(axis=0)
    cost = np.where(barred, 1000 * float(extent @ extent), 0.0)
    middle = np.zeros((number, number), dtype=np.int64)
    for width in range(2, number):
        for start in range(number - width):
            end = start + width
            between = np.arange(start + 1, end)
            cross = np.cross(points[between] - points[start], points[end] - points[start])
            total = cost[start, between] + cost[between, end] + np.sqrt((cross**2).sum(axis=1)) / 2
            best = int(np.argmin(total))
            cost[start, end] += total[best]
            middle[start, end] = between[best]
    triangles = []
    stack = [(0, number - 1)]
    while stack:
        start, end = stack.pop()
        if end - start < 2:
            continue
        peak = int(middle[start, end])
        triangles.append((start, peak, end))
        stack += [(start, peak), (peak, end)]
    return np.array(triangles, dtype=np.int64).reshape(-1, 3)


def _in_plane(points: Floats) -> Integers:
    """The triangulation of a long polyline, projected along its normal."""
    from manifold3d import triangulate

    centred = points - points.mean(axis=0)
    normal = np.cross(centred, np.roll(centred, -1, axis=0)).sum(axis=0)
    length = float(np.linalg.norm(normal))
    if length == 0:
        return np.zeros((0, 3), dtype=np.int64)
    flat = centred @ np.array(basis(vector(normal / length))[:2]).T
    return np.asarray(triangulate([flat]), dtype=np.int64).reshape(-1, 3)
