"""A depth camera in the outline of the Intel RealSense D415.

99 x 20 x 23 mm, two imagers 55 mm apart and the colour camera beside the left one. Source: Intel's
realsense2_description (urdf/_d415.urdf.xacro), which has the size and the places of the eyes,
20 mm, -35 mm and 35 mm left of the middle. Data sheet 337029 was not at hand; the place of the
projector is estimated.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.bar_camera import Lens, bar_camera
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK

#: From the middle to the left, as a part of the width 99 mm; radius as a part of the height.
_EYES = (Lens(20 / 99, 0.15), Lens(-35 / 99, 0.15), Lens(-0.08, 0.12), Lens(35 / 99, 0.15))


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, looking along x; size along x, y, z."""
    return bar_camera(size, _EYES, ALUMINIUM, BLACK)
