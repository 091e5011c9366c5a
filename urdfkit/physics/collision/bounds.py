"""Lower bounds of the distance of two bodies, for many poses at once, without measuring any."""

from __future__ import annotations

from math import inf

import numpy as np

from urdfkit.mesh.geometry import Floats

#: Measured poses that are kept of one pair: those with the tightest bounds.
_KEPT = 192

#: (12, 2): sums the squares of a difference of poses.
_SHIFT_AND_TURN = np.repeat(np.eye(2), [3, 9], axis=0)

_NEXT, _LAST = np.array([1, 2, 0]), np.array([2, 0, 1])


def apart(
    a: Floats, b: Floats, reach: float, rotation: Floats, offset: Floats, limit: float
) -> Floats:
    """(n,): two bodies are no nearer than that, in m; 0 or less where they may overlap.

    Args:
        a: (3,), half the sides of the box around the first.
        b: (3,), half the sides of the box around the second.
        reach: the radii of the spheres around the two together, in m.
        rotation: (n, 3, 3), of the second box in the frame of the first.
        offset: (n, 3), from center to center, in the same frame, in m.
        limit: bounds from here on, in m, are good enough.
    """
    bound = _norm(offset) - reach
    near = np.flatnonzero(bound < limit)
    boxes = _separation(a, b, rotation[near], offset[near])
    bound[near] = np.maximum(bound[near], boxes)
    return np.asarray(bound)


def _separation(a: Floats, b: Floats, rotation: Floats, offset: Floats) -> Floats:
    """(n,): how far two boxes are apart along the best of 15 axes, in m.

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


def poses(rotation: Floats, offset: Floats, radius: float) -> Floats:
    """(n, 12): poses of a body, in m, so that no point of it moves more than `moved` says.

    Args:
        rotation: (n, 3, 3).
        offset: (n, 3), of the center of a sphere around the body, in m.
        radius: of that sphere, in m.
    """
    # The spectral norm of the difference of two rotations is the Frobenius norm over sqrt(2).
    return np.hstack([offset, rotation.reshape(-1, 9) * (radius / np.sqrt(2))])


def moved(some: Floats, one: Floats) -> Floats:
    """(n,): how far points of a body can be from where they are in another pose, in m."""
    return np.asarray(np.sqrt(np.square(some - one) @ _SHIFT_AND_TURN).sum(axis=1))


class DistanceBound:
    """Poses in which a distance was measured; it holds, less the way moved, for those around."""

    def __init__(self) -> None:
        self._poses: list[Floats] = []
        self._distances: list[float] = []

    def add(self, pose: Floats, distance: float) -> None:
        """Remember the distance in a pose (12,)."""
        self._poses.append(pose)
        self._distances.append(distance)

    def bound(self, some: Floats) -> Floats:
        """(n,): in these poses (n, 12) the two bodies are no nearer than that, in m."""
        if not self._distances:
            return np.full(len(some), -inf)
        if len(self._distances) > 2 * _KEPT:
            best = np.argsort(self._distances)[-_KEPT:]
            self._poses = [self._poses[index] for index in best]
            self._distances = [self._distances[index] for index in best]
        known = np.array(self._poses)
        way = _ways(some[:, :3], known[:, :3]) + _ways(some[:, 3:], known[:, 3:])
        return np.asarray((np.array(self._distances) - way).max(axis=1))


def _ways(some: Floats, known: Floats) -> Floats:
    """(n, m): the distances between rows, never too short by rounding."""
    square = (some**2).sum(axis=1)[:, None] + (known**2).sum(axis=1) - 2 * some @ known.T
    return np.asarray(np.sqrt(np.maximum(square, 0) + 1e-12))


def _norm(vectors: Floats) -> Floats:
    return np.asarray(np.sqrt(np.einsum("ni,ni->n", vectors, vectors)))
