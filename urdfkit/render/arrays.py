"""The arrays that images are made of; single precision wherever there are many, for speed."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from urdfkit.core.spatial import Vector

Floats = NDArray[np.floating[Any]]
Integers = NDArray[np.integer[Any]]
Keys = NDArray[np.uint64]
Bools = NDArray[np.bool_]
Bytes = NDArray[np.uint8]

#: The depth of nothing, in m.
FAR = np.float32(1e9)


def unit(vectors: Floats) -> Floats:
    """Vectors (n, 3) at length 1; those without a direction stay 0."""
    norms = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    np.maximum(norms, np.float32(1e-30), out=norms)
    result: Floats = vectors / norms[:, None]
    return result


def dot(left: Floats, right: Floats) -> Floats:
    """Products of the rows of two (n, 3), or of the rows of one with a vector."""
    result: Floats = left[:, 0] * right[..., 0]
    result += left[:, 1] * right[..., 1]
    result += left[:, 2] * right[..., 2]
    return result


def cross(left: Floats, right: Floats) -> Floats:
    """Cross products of the rows of two (n, 3); faster than numpy's for many."""
    (a, b, c), (d, e, f) = left.T, right.T
    return np.stack((b * f - c * e, c * d - a * f, a * e - b * d), axis=1)


def bounds(points: Floats) -> tuple[Floats, Floats]:
    """The least and the greatest coordinates of points (n, 3); column by column, which is fast."""
    if not len(points):
        return np.zeros(3, dtype=np.float32), np.zeros(3, dtype=np.float32)
    columns = [points[:, axis] for axis in range(3)]
    return np.array([c.min() for c in columns]), np.array([c.max() for c in columns])


def single(places: Sequence[Vector]) -> Floats:
    """Places (n, 3) in single precision; what no number of it reaches is as far as nothing is."""
    near: Floats = np.clip(np.nan_to_num(np.array(places)), -FAR, FAR)
    return near.astype(np.float32).reshape(-1, 3)


def turned(vectors: Floats, rotation: Floats) -> Floats:
    """Vectors (n, 3) under a rotation, or another matrix (3, 3).

    Not by ``@``: a library for matrices starts threads for it, and rounds as its version likes.
    """
    result = np.empty((len(vectors), 3), dtype=np.float32)
    for axis in range(3):
        result[:, axis] = dot(vectors, rotation[axis].astype(np.float32))
    return result
