"""A stereo camera in the outline of the Stereolabs ZED.

175 x 30 x 33 mm with two lenses 120 mm apart. Sources: the baseline from Stereolabs,
https://support.stereolabs.com/hc/en-us/articles/360007395634, and with the height from their
zed_wrapper (urdf/zed_macro.urdf.xacro); their mesh of it (zed_ros2_description, meshes/zed.stl)
takes up 174.8 x 29.9 x 31.8 mm. The size is the one commonly quoted from the data sheet, which was
not at hand.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.bar_camera import Lens, bar_camera
from urdfkit.mesh.parts.palette import BLACK, DARK

#: 60 of 175 mm to either side.
_EYES = (Lens(60 / 175, 0.27), Lens(-60 / 175, 0.27))


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, looking along x; size along x, y, z."""
    return bar_camera(size, _EYES, DARK, BLACK)
