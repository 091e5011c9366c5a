"""A stereo camera in the outline of the Stereolabs ZED Mini.

124.5 x 30.5 x 26.5 mm with two lenses 63 mm apart. Sources: the baseline from Stereolabs,
https://support.stereolabs.com/hc/en-us/articles/360007395634, and with the height from their
zed_wrapper (urdf/zed_macro.urdf.xacro); their mesh of it (zed_ros2_description, meshes/zedm.stl)
takes up 125.2 x 29.5 x 26.6 mm. The size is the one commonly quoted from the data sheet, which was
not at hand.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.bar_camera import Lens, bar_camera
from urdfkit.mesh.parts.palette import BLACK, DARK

#: 31.5 of 124.5 mm to either side.
_EYES = (Lens(31.5 / 124.5, 0.27), Lens(-31.5 / 124.5, 0.27))


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, looking along x; size along x, y, z."""
    return bar_camera(size, _EYES, DARK, BLACK)
