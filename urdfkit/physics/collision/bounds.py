"""Lower bounds of the distance of two bodies in many poses at once."""

from math import inf

import numpy as np

from urdfkit.mesh.geometry import Floats

_NEXT, _LAST = np.array([1, 2, 0]), np.array([2, 0, 1])


def distance_bounds(
    a: Floats, b: Floats, reach: float, rotation: Floats, offset: Floats, limit: float
) -> Floats:
    """(n,), lower bounds of the distance in m; 0 or less if the bodies may overlap.

    Args:
        a: (3,), half sides of the bounding box of the first body.
        b: (3,), half sides of the bounding box of the second body.
        reach: sum of the radii of the bounding spheres, in m.
        rotation: (n, 3, 3), of the second box in the frame of the first.
        offset: (n, 3), from center to center, in the same frame, in m.
        limit: bounds above this limit, in m, are sufficient.
    """
    bound = np.sqrt(np.einsum("ni,ni->n", offset, offset)) - reach
    near = np.flatnonzero(bound < limit)
    boxes = _separation(a, b, rotation[near], offset[near])
    bound[near] = np.maximum(bound[near], boxes)
    return np.asarray(bound)


def _separation(a: Floats, b: Floats, rotation: Floats, offset: Floats) -> Floats:
    """(n,), separation of two boxes along the best of 15 axes, in m.

    Source: S. Gottschalk, M. C. Lin, D. Manocha, OBBTree, SIGGRAPH 1996.
    """
    size = np.abs(rotation)
    along_b = np.einsum("ni,nij->nj", offset, rotation)
    best = (np.abs(offset) - a - size @ b).max(axis=1, initial=-inf)
    best = np.maximum(best, (np.abs(along_b) - b - a @ size).max(axis=1, initial=-inf))
    for i in range(3):  # the axes e_i x r_m, for m = 0, 1, 2 at once
        j, k = (i + 1) % 3, (i + 2) % 3
        length = np.sqrt(np.maximum(1 - rotation[:, i] ** 2, 0))
        reach = a[j] * size[:, k] + a[k] * size[:, j]
        reach += b[_NEXT] * size[:, i, _LAST] + b[_LAST] * size[:, i, _NEXT]
        gap = np.abs(offset[:, k, None] * rotation[:, j] - offset[:, j, None] * rotation[:, k])
        with np.errstate(divide="ignore", invalid="ignore"):
            axis = np.where(length > 1e-6, (gap - reach) / length, -inf)
        best = np.maximum(best, axis.max(axis=1, initial=-inf))
    return np.asarray(best)
