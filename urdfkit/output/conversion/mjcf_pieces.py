"""Geoms and rotations in the conventions of MuJoCo."""

from __future__ import annotations

from collections.abc import Iterable

import mujoco
import numpy as np

from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Transform

#: Size of a mesh, which its file gives.
NO_SIZE = (0.0, 0.0, 0.0)


class Piece(Record):
    """A geom in the frame of its visual or collision."""

    kind: str  # of the shape
    size: tuple[float, ...]  # MuJoCo's size: half the edges; radius and half the length
    frame: Transform = Transform()
    mesh: str = ""  # name of the mesh; empty for a primitive


class WrittenShape(Record):
    """The geoms of a visual or collision."""

    geoms: tuple[int, ...]  # indices
    is_exact: bool  # False for simpler shapes


def halved(kind: str, sizes: Iterable[float]) -> tuple[float, ...]:
    """MuJoCo's size: half the edges of a box; radius and half the length of other shapes."""
    if kind == "box":
        return tuple(edge / 2 for edge in sizes)
    radius, *length = sizes
    return (radius, length[0] / 2 if length else 0.0, 0.0)


def quaternion(rotation: Rotation) -> tuple[float, float, float, float]:
    """Unit quaternion of a rotation, real part first."""
    result = np.zeros(4)
    mujoco.mju_mat2Quat(result, np.array(rotation).ravel())
    w, x, y, z = map(float, result)
    return w, x, y, z
