"""Polygons as triangles."""

import numpy as np

from urdfkit.mesh.geometry import Flags, Floats, Integers

#: What a corner turns the wrong way, relative to the sharpest one, that is no rounding.
_TURN = 1e-6


def triangles(counts: Integers, places: Floats) -> Integers:
    """Polygons as triangles that cover what the polygons do, those with dents included.

    Args:
        counts: (p,), how many corners each has, one polygon after the other.
        places: (c, 3), of the corners.

    Returns:
        (t, 3), numbers of corners; polygons of less than three have no triangles.
    """
    dented = _dented(counts, places)
    plain = fans(counts)
    if not dented.any():
        return plain
    keep = ~np.repeat(dented, np.maximum(counts - 2, 0))
    starts = np.cumsum(counts) - counts
    cut = [
        _cut(places[starts[i] : starts[i] + counts[i]]) + starts[i] for i in np.flatnonzero(dented)
    ]
    return np.concatenate([plain[keep], *cut])


def fans(counts: Integers) -> Integers:
    """Polygons as fans of triangles.

    Args:
        counts: (p,), how many corners each has, one polygon after the other.

    Returns:
        (t, 3), numbers of corners; polygons of less than three have no triangles.
    """
    first, within = _spread(counts)
    return np.stack([first, first + within + 1, first + within + 2], axis=1)


def _dented(counts: Integers, places: Floats) -> Flags:
    """The polygons with a corner that turns the other way than the polygon as a whole."""
    found = np.zeros(len(counts), dtype=bool)
    starts = np.cumsum(counts) - counts
    for number in np.unique(counts[counts > 3]):
        of_number = np.flatnonzero(counts == number)
        corners = places[starts[of_number][:, None] + np.arange(number)]
        with np.errstate(over="ignore", invalid="ignore"):  # what is not finite is no dent
            edges = np.roll(corners, -1, axis=1) - corners
            turns = np.cross(np.roll(edges, 1, axis=1), edges)
            along = np.einsum("pkj,pj->pk", turns, _normals(corners))
            found[of_number] = along.min(axis=1) < -_TURN * np.abs(along).max(axis=1)
    return found


def _normals(corners: Floats) -> Floats:
    """(p, 3), twice the area of each of some polygons of equal number, (p, k, 3), as a vector."""
    spokes = corners - corners[:, :1]
    found: Floats = np.cross(spokes, np.roll(spokes, -1, axis=1)).sum(axis=1)
    return found


def _cut(corners: Floats) -> Integers:
    """One polygon, (k, 3), by cutting off its ears; as a fan where that fails."""
    import mapbox_earcut

    fan = fans(np.array([len(corners)]))
    normal = _normals(corners[None])[0]
    if not np.isfinite(corners).all() or not normal.any():
        return fan
    across = int(np.argmax(np.abs(normal)))
    flat = np.ascontiguousarray(np.delete(corners, across, axis=1))
    ends = np.array([len(corners)], dtype=np.uint32)
    ears = mapbox_earcut.triangulate_float64(flat, ends).astype(np.int64).reshape(-1, 3)
    if len(ears) != len(fan):
        return fan
    along = np.einsum("tj,j->t", _normals(corners[ears]), normal)
    ears[along < 0] = ears[along < 0][:, ::-1]
    return ears


def strips(counts: Integers) -> Integers:
    """Strips as triangles; every other one is turned, so that all look the same way.

    Args:
        counts: (p,), how many corners each has, one strip after the other.
    """
    first, within = _spread(counts)
    at = first + within
    odd = within % 2
    return np.stack([at, at + 1 + odd, at + 2 - odd], axis=1)


def _spread(counts: Integers) -> tuple[Integers, Integers]:
    """The first corner of each triangle's polygon, and the triangle's number in the polygon."""
    triangles = np.maximum(counts - 2, 0)
    ends = np.cumsum(triangles)
    within = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - triangles, triangles)
    return np.repeat(np.cumsum(counts) - counts, triangles), within
