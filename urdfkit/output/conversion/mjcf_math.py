"""Conversion of rotations to MuJoCo's quaternions."""

import mujoco
import numpy as np

from urdfkit.core.spatial import Rotation


def quaternion(rotation: Rotation) -> tuple[float, float, float, float]:
    """Unit quaternion of a rotation, real part first."""
    result = np.zeros(4)
    mujoco.mju_mat2Quat(result, np.array(rotation).ravel())
    w, x, y, z = map(float, result)
    return w, x, y, z
