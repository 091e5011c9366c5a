"""Holes closed with triangles, so that as little area as possible is added."""

from __future__ import annotations

from itertools import pairwise

import numpy as np

from urdfkit.meshes.edges import Edges
from urdfkit.meshes.geometry import Floats, Integers
from urdfkit.meshes.repair.soup import Soup

#: Rims of more edges are closed in their plane; the best triangulation costs the third power.
_LONGEST = 120


def fill(soup: Soup) -> Soup:
    """Every rim that goes around closed."""
    if not len(soup.faces):
        return soup
    faces: list[Integers] = []
    parts: list[int] = []
    for loop, part in _loops(soup):
        triangles = triangulated(soup.points[loop])
        faces.append(loop[triangles])
        parts += [part] * len(triangles)
    if not faces:
        return soup
    return soup.with_faces(np.concatenate(faces), np.array(parts, dtype=np.int64))


def _loops(soup: Soup) -> list[tuple[Integers, int]]:
    """The rims, each as points in the order in which filling faces see them, and a part."""
    edges = Edges(soup.faces)
    rows, sides = np.nonzero(edges.is_open[edges.of_face])
    following: dict[int, list[tuple[int, int]]] = {}
    for face, side in zip(rows.tolist(), sides.tolist(), strict=True):
        start, end = int(soup.faces[face, side]), int(soup.faces[face, (side + 1) % 3])
        following.setdefault(end, []).append((start, int(soup.parts[face])))
    loops = []
    while following:
        loop, part = _walk(following)
        if len(loop) >= 3:
            loops.append((np.array(loop, dtype=np.int64), part))
    return loops


def _walk(following: dict[int, list[tuple[int, int]]]) -> tuple[list[int], int]:
    """Take one rim out; empty if it leads nowhere.

    Where rims touch in a point, the walk comes back to it and cuts off what it has gone around.
    """
    here = next(iter(following))
    path, places, part = [here], {here: 0}, 0
    while True:
        choices = following.get(here)
        if not choices:
            return [], 0
        there, part = choices.pop()
        if not choices:
            del following[here]
        if there in places:
            loop = path[places[there] :]
            # What the walk passed before it came to this loop goes back.
            for start, end in pairwise(path[: places[there] + 1]):
                following.setdefault(start, []).append((end, part))
            return loop, part
        places[there] = len(path)
        path.append(there)
        here = there


def triangulated(points: Floats) -> Integers:
    """Triangles between the points of a closed line, as (k, 3) indices, in its direction."""
    if len(points) > _LONGEST:
        return _in_plane(points)
    return _smallest(points)


def _smallest(points: Floats) -> Integers:
    """The triangulation of least area, which for a flat hole has no folds.

    Source: G. Barequet, M. Sharir, "Filling gaps in the boundary of a polyhedron", Computer Aided
    Geometric Design 12 (1995): dynamic programming over the stretches of the line.
    """
    number = len(points)
    cost = np.zeros((number, number))
    middle = np.zeros((number, number), dtype=np.int64)
    for width in range(2, number):
        for start in range(number - width):
            end = start + width
            between = np.arange(start + 1, end)
            cross = np.cross(points[between] - points[start], points[end] - points[start])
            total = cost[start, between] + cost[between, end] + np.sqrt((cross**2).sum(axis=1)) / 2
            best = int(np.argmin(total))
            cost[start, end] = total[best]
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
    """The triangulation of a long line, seen along its normal."""
    from manifold3d import triangulate

    centred = points - points.mean(axis=0)
    normal = np.cross(centred, np.roll(centred, -1, axis=0)).sum(axis=0)
    length = float(np.linalg.norm(normal))
    if length == 0:
        return np.zeros((0, 3), dtype=np.int64)
    normal /= length
    helper = np.eye(3)[int(np.argmin(np.abs(normal)))]
    x = np.cross(helper, normal)
    x /= np.linalg.norm(x)
    y = np.cross(normal, x)
    flat = np.column_stack([centred @ x, centred @ y])
    return np.asarray(triangulate([flat]), dtype=np.int64).reshape(-1, 3)
