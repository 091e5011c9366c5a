"""Array types and functions for rendering; large arrays have single precision, for speed."""

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

#: Depth in m of pixels without a surface.
FAR = np.float32(1e9)


def unit(vectors: Floats) -> Floats:
    """Unit vectors (n, 3); zero vectors stay 0."""
    norms = np.sqrt(np.einsum("ij,ij->i", vectors, vectors))
    np.maximum(norms, np.float32(1e-30), out=norms)
    return np.asarray(vectors / norms[:, None])


def dot(left: Floats, right: Floats) -> Floats:
    """Dot products of the rows of two arrays (n, 3), or of the rows of one with a vector."""
    result: Floats = left[:, 0] * right[..., 0]
    result += left[:, 1] * right[..., 1]
    result += left[:, 2] * right[..., 2]
    return result


def cross(left: Floats, right: Floats) -> Floats:
    """Cross products of the rows of two arrays (n, 3); faster than numpy for large arrays."""
    (a, b, c), (d, e, f) = left.T, right.T
    return np.stack((b * f - c * e, c * d - a * f, a * e - b * d), axis=1)


def bounds(points: Floats) -> tuple[Floats, Floats]:
    """The least and the greatest coordinates of points (n, 3), computed by column for speed."""
    if not len(points):
        return np.zeros(3, dtype=np.float32), np.zeros(3, dtype=np.float32)
    columns = [points[:, axis] for axis in range(3)]
    return np.array([c.min() for c in columns]), np.array([c.max() for c in columns])


def single(places: Sequence[Vector]) -> Floats:
    """Positions (n, 3) in single precision, limited to `FAR`."""
    near: Floats = np.clip(np.nan_to_num(np.array(places)), -FAR, FAR)
    return near.astype(np.float32).reshape(-1, 3)


def rotated(vectors: Floats, rotation: Floats) -> Floats:
    """Vectors (n, 3), multiplied with a rotation or another matrix (3, 3).

    Without ``@``: BLAS libraries start threads, and their rounding depends on the version.
    """
    result = np.empty((len(vectors), 3), dtype=np.float32)
    for axis in range(3):
        result[:, axis] = dot(vectors, rotation[axis].astype(np.float32))
    return result
