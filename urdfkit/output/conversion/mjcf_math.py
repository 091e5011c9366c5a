"""Numbers as MuJoCo has them."""

import mujoco
import numpy as np

from urdfkit.core.spatial import Rotation


def quaternion(rotation: Rotation) -> tuple[float, float, float, float]:
    """The unit quaternion of a rotation, its real part first."""
    found = np.zeros(4)
    mujoco.mju_mat2Quat(found, np.array(rotation).ravel())
    w, x, y, z = map(float, found)
    return w, x, y, z
