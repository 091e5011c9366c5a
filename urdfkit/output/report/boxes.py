"""The box of uniform density that a mass and an inertia tensor describe."""

from __future__ import annotations

import numpy as np

from urdfkit.core.spatial import Transform, Vector
from urdfkit.robot.model import Inertial


def inertia_box(inertial: Inertial, mass: float) -> tuple[Vector, Transform] | None:
    """The edges of the box in m, and where its middle is in the frame of the link.

    Of a solid box the moment about x is ``m (y^2 + z^2) / 12``, so ``x^2 = 6 (b + c - a) / m``
    for moments a, b, c about x, y, z. An edge is 0 where a tensor belongs to no real body.

    Returns:
        None without a tensor, or where it overflows.
    """
    if inertial.tensor is None:
        return None
    xx, xy, xz, yy, yz, zz = inertial.tensor.value
    moments, axes = np.linalg.eigh([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
    if np.linalg.det(axes) < 0:
        axes = -axes
    with np.errstate(over="ignore", invalid="ignore"):
        squares = 6 * (moments.sum() - 2 * moments) / mass
    if not (np.isfinite(squares).all() and np.isfinite(axes).all()):
        return None
    x, y, z = np.sqrt(np.maximum(squares, 0)).tolist()
    a, b, c = (tuple(row) for row in axes.tolist())
    turned = inertial.origin @ Transform((a, b, c))
    return (x, y, z), turned
