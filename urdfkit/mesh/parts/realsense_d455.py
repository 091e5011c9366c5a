"""A depth camera in the outline of the Intel RealSense D455.

124 x 26 x 29 mm, two imagers 95 mm apart, the colour camera and the projector between them.
Source: Intel's realsense2_description (urdf/_d455.urdf.xacro), which has the size and the places
of the eyes, 47.5 mm, -47.5 mm and -11.5 mm left of the middle. Data sheet 337029 was not at hand;
the place of the projector is estimated.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.bar_camera import Lens, bar_camera
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK

#: From the middle to the left, as a part of the width 124 mm; radius as a part of the height.
_EYES = (Lens(47.5 / 124, 0.15), Lens(-47.5 / 124, 0.15), Lens(-11.5 / 124, 0.15), Lens(0.1, 0.11))


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, looking along x; size along x, y, z."""
    return bar_camera(size, _EYES, ALUMINIUM, BLACK)
