"""Vertices made one: where they are at the same place, and where only rounding parts them."""

import numpy as np

from urdfkit.mesh.edges import Edges, three_cornered
from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.mesh.grouping import components

#: Vertices nearer than this are one, relative to the largest coordinate.
ROUNDING = 1e-6
#: A coordinate beyond this is no place on a robot, in whatever unit.
_FAR = 1e9


def finite(vertices: Floats) -> Flags:
    """(n,), True for vertices without nan, infinity, and numbers as good as that."""
    return np.asarray((np.abs(np.nan_to_num(vertices, nan=np.inf)) < _FAR).all(axis=1))


def weld_finite(vertices: Floats, faces: Integers) -> tuple[Floats, Integers, Flags]:
    """`weld` without faces that have a corner which is not finite; (m,), True for the others."""
    is_finite = finite(vertices)
    kept = np.asarray(is_finite[faces].all(axis=1))
    return (*weld(np.where(is_finite[:, None], vertices, 0.0), faces[kept]), kept)


def weld(vertices: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """Merge vertices at exactly the same place, and drop those that no triangle uses."""
    used = np.zeros(len(vertices), dtype=bool)
    used[faces] = True
    places = vertices[used] + 0.0  # which makes -0.0 and 0.0 the same
    numbers = np.cumsum(used) - 1
    first, which = _distinct(places)
    return places[first], which[numbers[faces]]


def _distinct(places: Floats) -> tuple[Integers, Integers]:
    """For each different place, (n, 3), where it is first; for each place which of them it is."""
    # Three columns are mixed to one number, by odd constants of 64 bits, which sorts fast.
    columns = np.ascontiguousarray(places, dtype=np.float64).view(np.uint64)
    with np.errstate(over="ignore"):
        key = columns[:, 0] * np.uint64(0x9E3779B97F4A7C15)
        key = (key ^ (key >> np.uint64(29))) + columns[:, 1] * np.uint64(0xBF58476D1CE4E5B9)
        key = (key ^ (key >> np.uint64(32))) + columns[:, 2] * np.uint64(0x94D049BB133111EB)
    _, first, which = np.unique(key, return_index=True, return_inverse=True)
    if not np.array_equal(places[first][which], places):  # two places gave one number
        _, first, which = np.unique(places, axis=0, return_index=True, return_inverse=True)
    return first, which.reshape(-1)


def close_seams(places: Floats, faces: Integers) -> tuple[Integers, Edges]:
    """Faces, of whose open edges vertices are one that only rounding keeps apart; and their edges.

    Points nearer than half a cell share a cell of a grid, or of one that is shifted by half a cell
    along some axes.

    Args:
        places: (n, 3), welded.
        faces: (m, 3).

    Returns:
        The faces, and the edges of those that have three corners.
    """
    edges = Edges(faces[three_cornered(faces)])
    loose = np.unique(edges.ends[edges.is_unpaired])
    if not len(loose):
        return faces, edges
    cells = places[loose] / (2 * ROUNDING * (float(np.abs(places).max()) or 1.0))
    pairs = []
    for shift in np.ndindex(2, 2, 2):
        first, which = _distinct(np.floor(cells + np.array(shift) / 2) + 0.0)
        pairs.append(np.stack([first[which], np.arange(len(loose))], axis=1))
    same = np.arange(len(places))
    same[loose] = loose[components(len(loose), np.concatenate(pairs))]
    faces = same[faces]
    return faces, Edges(faces[three_cornered(faces)])
