"""Polygons as triangles."""

from __future__ import annotations

import numpy as np

from urdfkit.meshes.geometry import Integers


def fans(counts: Integers) -> Integers:
    """Polygons as fans of triangles.

    Args:
        counts: (p,), how many corners each has, one polygon after the other.

    Returns:
        (t, 3), numbers of corners; polygons of less than three have no triangles.
    """
    first, within = _spread(counts)
    return np.stack([first, first + within + 1, first + within + 2], axis=1)


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
    """For each triangle the first corner of its polygon, and its number in it."""
    triangles = np.maximum(counts - 2, 0)
    ends = np.cumsum(triangles)
    within = np.arange(ends[-1] if len(ends) else 0) - np.repeat(ends - triangles, triangles)
    return np.repeat(np.cumsum(counts) - counts, triangles), within
