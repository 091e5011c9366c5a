"""Open edges that belong together: points that nearly meet, and points that lie on an edge."""

from __future__ import annotations

import numpy as np
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from urdfkit.mesh.edges import Edges
from urdfkit.mesh.geometry import Integers
from urdfkit.mesh.repair.soup import TriangleSoup

#: Rounds of splitting: a long edge may meet several points.
_ROUNDS = 8
#: More points on open edges than this are a heap of triangles, and no seams.
_MOST = 200_000


def weld_rims(soup: TriangleSoup, tolerance: float) -> TriangleSoup:
    """Points of open edges that are nearer to each other than a tolerance made one.

    Points that are not on an open edge stay as they are: what is closed is not to be changed.
    """
    rim = _rim_points(soup)
    if len(rim) < 2:
        return soup
    pairs = cKDTree(soup.points[rim]).query_pairs(tolerance, output_type="ndarray")
    if not len(pairs):
        return soup
    one, other = rim[pairs[:, 0]], rim[pairs[:, 1]]
    number = len(soup.points)
    graph = coo_array((np.ones(len(one)), (one, other)), shape=(number, number))
    _, labels = connected_components(graph, directed=False)
    _, first = np.unique(labels, return_index=True)
    return soup.merged(first[labels].astype(np.int64))


def split_at_points(soup: TriangleSoup, tolerance: float) -> TriangleSoup:
    """Faces whose open side runs through a point of another open side, cut there in two."""
    for _ in range(_ROUNDS):
        cuts = _cuts(soup, tolerance)
        if not cuts:
            break
        soup = _cut(soup, cuts)
    return soup


def _rim_points(soup: TriangleSoup) -> Integers:
    if not len(soup.faces):
        return np.zeros(0, dtype=np.int64)
    edges = Edges(soup.faces)
    return np.unique(edges.ends[edges.is_open])


def _cuts(soup: TriangleSoup, tolerance: float) -> dict[int, tuple[int, int]]:
    """By face: the side to cut, and the point where."""
    rim = _rim_points(soup)
    if not 3 < len(rim) <= _MOST:
        return {}
    edges = Edges(soup.faces)
    tree = cKDTree(soup.points[rim])
    faces, sides = np.nonzero(edges.is_open[edges.of_face])
    cuts: dict[int, tuple[int, int]] = {}
    for face, side in zip(faces.tolist(), sides.tolist(), strict=True):
        if face in cuts:
            continue
        start, end = soup.faces[face, side], soup.faces[face, (side + 1) % 3]
        point = _point_on(soup, tree, rim, int(start), int(end), tolerance)
        if point is not None and point not in soup.faces[face]:
            cuts[face] = (side, point)
    return cuts


def _point_on(
    soup: TriangleSoup, tree: cKDTree, rim: Integers, start: int, end: int, tolerance: float
) -> int | None:
    """A rim point that lies on the line between two points; that nearest to its middle."""
    a, b = soup.points[start], soup.points[end]
    length = float(np.linalg.norm(b - a))
    if length <= 4 * tolerance:
        return None
    near = rim[tree.query_ball_point((a + b) / 2, length / 2)]
    if len(near) <= 2:
        return None
    offsets = soup.points[near] - a
    along = offsets @ (b - a) / length
    away = np.linalg.norm(offsets - np.outer(along, (b - a) / length), axis=1)
    on_it = (away <= tolerance) & (along > 2 * tolerance) & (along < length - 2 * tolerance)
    if not on_it.any():
        return None
    found = near[on_it][np.argmin(np.abs(along[on_it] - length / 2))]
    return int(found)


def _cut(soup: TriangleSoup, cuts: dict[int, tuple[int, int]]) -> TriangleSoup:
    which = np.fromiter(cuts, dtype=np.int64)
    sides = np.array([cuts[face][0] for face in cuts])
    points = np.array([cuts[face][1] for face in cuts], dtype=np.int64)
    rows = np.arange(len(which))
    first, second = soup.faces[which].copy(), soup.faces[which].copy()
    first[rows, (sides + 1) % 3] = points
    second[rows, sides] = points
    whole = np.ones(len(soup.faces), dtype=bool)
    whole[which] = False
    rest = soup.kept(whole)
    added = np.concatenate([first, second])
    corners = np.concatenate([soup.corners[which], soup.corners[which]])
    parts = np.concatenate([soup.parts[which], soup.parts[which]])
    return TriangleSoup(
        soup.points,
        np.concatenate([rest.faces, added]),
        np.concatenate([rest.corners, corners]),
        np.concatenate([rest.parts, parts]),
    )
