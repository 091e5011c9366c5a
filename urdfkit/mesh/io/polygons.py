"""Triangulation of polygons, fans and strips."""

import numpy as np

from urdfkit.mesh.geometry import Flags, Floats, Integers

#: Turn of a concave corner, relative to the sharpest corner, above which it is not rounding.
_TURN = 1e-6

#: The axes of a plane that a polygon is projected to, by the axis that its normal is nearest to.
_OTHER_AXES = np.array([(1, 2), (0, 2), (0, 1)])


def triangles(counts: Integers, places: Floats) -> Integers:
    """The triangulation of convex and concave polygons.

    Args:
        counts: (p,), number of corners of each polygon, one polygon after the other.
        places: (c, 3), positions of the corners.

    Returns:
        (t, 3), indices of corners; polygons of fewer than three have no triangles.
    """
    normals, is_concave = _orientations(counts, places)
    convex = fans(counts)
    concave = np.flatnonzero(is_concave)
    if not len(concave):
        return convex
    keep = ~np.repeat(is_concave, np.maximum(counts - 2, 0))
    return np.concatenate([convex[keep], _clip_ears(counts, places, normals, concave)])


def fans(counts: Integers) -> Integers:
    """Polygons as fans of triangles.

    Args:
        counts: (p,), number of corners of each polygon, one polygon after the other.

    Returns:
        (t, 3), indices of corners; polygons of fewer than three have no triangles.
    """
    first, within = _spread(counts)
    return np.stack([first, first + within + 1, first + within + 2], axis=1)


def _orientations(counts: Integers, places: Floats) -> tuple[Floats, Flags]:
    """Normals of polygons, and which have a corner that turns against the others.

    Returns:
        (p, 3), 0 for triangles; and (p,), True for concave polygons.
    """
    normals, is_concave = np.zeros((len(counts), 3)), np.zeros(len(counts), dtype=bool)
    starts = np.cumsum(counts) - counts
    for number in np.unique(counts[counts > 3]):
        of_number = np.flatnonzero(counts == number)
        corners = places[starts[of_number][:, None] + np.arange(number)]
        with np.errstate(over="ignore", invalid="ignore"):  # non-finite is not concave
            edges = np.roll(corners, -1, axis=1) - corners
            turns = np.cross(np.roll(edges, 1, axis=1), edges)
            normals[of_number] = _normals(corners)
            along = np.einsum("pkj,pj->pk", turns, normals[of_number])
            is_concave[of_number] = along.min(axis=1) < -_TURN * np.abs(along).max(axis=1)
    return normals, is_concave


def _normals(corners: Floats) -> Floats:
    """(p, 3), normals of polygons (p, k, 3), twice as long as their area."""
    spokes = corners - corners[:, :1]
    return np.asarray(np.cross(spokes, np.roll(spokes, -1, axis=1)).sum(axis=1))


def _clip_ears(counts: Integers, places: Floats, normals: Floats, concave: Integers) -> Integers:
    """(t, 3), the triangles of the concave polygons by ear clipping; of a fan where that fails."""
    from mapbox_earcut import triangulate_float64

    starts, across = np.cumsum(counts) - counts, np.argmax(np.abs(normals), axis=1)
    pieces, is_clipped = [], []
    for polygon in concave:
        start, number = starts[polygon], counts[polygon]
        flat = places[start : start + number].take(_OTHER_AXES[across[polygon]], axis=1)
        ears = triangulate_float64(flat, np.array([number], dtype=np.uint32)).reshape(-1, 3)
        is_clipped.append(len(ears) == number - 2)
        pieces.append(start + (ears if is_clipped[-1] else fans(counts[[polygon]])))
    faces = np.concatenate(pieces).astype(np.int64)
    triangles = counts[concave] - 2
    along = np.einsum("tj,tj->t", _normals(places[faces]), normals[np.repeat(concave, triangles)])
    flipped = np.repeat(is_clipped, triangles) & (along < 0)
    faces[flipped] = faces[flipped][:, ::-1]
    return faces


def strips(counts: Integers) -> Integers:
    """Strips as triangles; every second triangle is flipped for consistent orientation.

    Args:
        counts: (p,), number of corners of each strip, one strip after the other.
    """
    first, within = _spread(counts)
    at = first + within
    odd = within % 2
    return np.stack([at, at + 1 + odd, at + 2 - odd], axis=1)


def _spread(counts: Integers) -> tuple[Integers, Integers]:
    """The first corner of the polygon of each triangle, and the triangle's index in the polygon."""
    triangles = np.maximum(counts - 2, 0)
    ends = np.cumsum(triangles)
    within = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - triangles, triangles)
    return np.repeat(np.cumsum(counts) - counts, triangles), within
