"""Merging of vertices at the same position, exactly or up to rounding."""

import numpy as np

from urdfkit.mesh.edges import Edges, have_distinct_corners
from urdfkit.mesh.geometry import Flags, Floats, Integers
from urdfkit.mesh.grouping import components, equal_numbers

#: Distance below which vertices are merged, relative to the largest coordinate.
ROUNDING = 1e-6
#: A coordinate beyond this is not part of a robot in any unit.
_MAX_COORDINATE = 1e9


def finite(vertices: Floats) -> Flags:
    """(n,), True for vertices without nan, infinity or absurdly large coordinates."""
    return np.asarray((np.abs(np.nan_to_num(vertices, nan=np.inf)) < _MAX_COORDINATE).all(axis=1))


def weld_finite(vertices: Floats, faces: Integers) -> tuple[Floats, Integers, Flags]:
    """`weld` without faces that have a non-finite corner; and (m,), True for the welded faces."""
    is_finite = finite(vertices)
    is_valid = np.asarray(is_finite[faces].all(axis=1))
    return (*weld(np.where(is_finite[:, None], vertices, 0.0), faces[is_valid]), is_valid)


def weld(vertices: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """Merge vertices at exactly the same position and drop unused vertices."""
    used = np.zeros(len(vertices), dtype=bool)
    used[faces] = True
    places = vertices[used] + 0.0  # which makes -0.0 and 0.0 the same
    numbers = np.cumsum(used) - 1
    first, which = _distinct(places)
    return places[first], which[numbers[faces]]


def _distinct(places: Floats) -> tuple[Integers, Integers]:
    """Indices of the first of equal rows of (n, 3); and for each row, which of these it equals."""
    # The three columns are hashed to one number with odd 64-bit constants, which sorts fast.
    columns = np.ascontiguousarray(places, dtype=np.float64).view(np.uint64)
    with np.errstate(over="ignore"):
        key = columns[:, 0] * np.uint64(0x9E3779B97F4A7C15)
        key = (key ^ (key >> np.uint64(29))) + columns[:, 1] * np.uint64(0xBF58476D1CE4E5B9)
        key = (key ^ (key >> np.uint64(32))) + columns[:, 2] * np.uint64(0x94D049BB133111EB)
    first, which, _ = equal_numbers(key)
    if not np.array_equal(places[first][which], places):  # a hash collision
        _, first, which = np.unique(places, axis=0, return_index=True, return_inverse=True)
    return first, which.reshape(-1)


def close_seams(places: Floats, faces: Integers) -> tuple[Integers, Edges]:
    """Merge vertices of open edges that differ by rounding only.

    Points nearer than half a cell share a cell of a grid, or of a copy of the grid that is shifted
    by half a cell along some axes.

    Args:
        places: (n, 3), welded.
        faces: (m, 3).

    Returns:
        The faces, and the edges of the faces with three distinct corners.
    """
    edges = Edges(faces[have_distinct_corners(faces)])
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
    return faces, Edges(faces[have_distinct_corners(faces)])
