"""Triangulation of polygons, fans and strips."""

import numpy as np

from urdfkit.mesh.geometry import Flags, Floats, Integers

#: Turn of a concave corner, relative to the sharpest corner, above which it is not rounding.
_TURN = 1e-6


def triangles(counts: Integers, places: Floats) -> Integers:
    """The triangulation of convex and concave polygons.

    Args:
        counts: (p,), number of corners of each polygon, one polygon after the other.
        places: (c, 3), positions of the corners.

    Returns:
        (t, 3), indices of corners; polygons of fewer than three have no triangles.
    """
    concave = _are_concave(counts, places)
    convex = fans(counts)
    if not concave.any():
        return convex
    keep = ~np.repeat(concave, np.maximum(counts - 2, 0))
    starts = np.cumsum(counts) - counts
    ears = [
        _clip_ears(places[starts[i] : starts[i] + counts[i]]) + starts[i]
        for i in np.flatnonzero(concave)
    ]
    return np.concatenate([convex[keep], *ears])


def fans(counts: Integers) -> Integers:
    """Polygons as fans of triangles.

    Args:
        counts: (p,), number of corners of each polygon, one polygon after the other.

    Returns:
        (t, 3), indices of corners; polygons of fewer than three have no triangles.
    """
    first, within = _spread(counts)
    return np.stack([first, first + within + 1, first + within + 2], axis=1)


def _are_concave(counts: Integers, places: Floats) -> Flags:
    """(p,), True for polygons with a corner that turns against the polygon's orientation."""
    is_concave = np.zeros(len(counts), dtype=bool)
    starts = np.cumsum(counts) - counts
    for number in np.unique(counts[counts > 3]):
        of_number = np.flatnonzero(counts == number)
        corners = places[starts[of_number][:, None] + np.arange(number)]
        with np.errstate(over="ignore", invalid="ignore"):  # non-finite is not concave
            edges = np.roll(corners, -1, axis=1) - corners
            turns = np.cross(np.roll(edges, 1, axis=1), edges)
            along = np.einsum("pkj,pj->pk", turns, _normals(corners))
            is_concave[of_number] = along.min(axis=1) < -_TURN * np.abs(along).max(axis=1)
    return is_concave


def _normals(corners: Floats) -> Floats:
    """(p, 3), normals of polygons (p, k, 3), twice as long as their area."""
    spokes = corners - corners[:, :1]
    return np.asarray(np.cross(spokes, np.roll(spokes, -1, axis=1)).sum(axis=1))


def _clip_ears(corners: Floats) -> Integers:
    """The triangulation of a polygon (k, 3) by ear clipping; a fan if that fails."""
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
