"""A depth camera in the outline of the Intel RealSense D435.

90 x 25 x 25 mm, two imagers 50 mm apart with the projector between them and the colour camera at
the side. Source: Intel's realsense2_description (urdf/_d435.urdf.xacro), which has the size and the
places of the eyes, 17.5 mm, -32.5 mm and 32.5 mm left of the middle. Data sheet 337029 was not
at hand; the place of the projector is estimated.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.bar_camera import Lens, bar_camera
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK

#: From the middle to the left, as a part of the width 90 mm; radius as a part of the height.
_EYES = (Lens(0.194, 0.17), Lens(-0.361, 0.17), Lens(-0.05, 0.12), Lens(0.361, 0.17))


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, looking along x; size along x, y, z."""
    return bar_camera(size, _EYES, ALUMINIUM, BLACK)
