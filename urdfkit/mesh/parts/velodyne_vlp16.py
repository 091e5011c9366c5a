"""A spinning 3D lidar in the outline of the Velodyne VLP-16.

103.3 mm wide and 71.7 mm high: an aluminium base, a dark window all around, an aluminium cap.
Velodyne's "VLP-16 User Manual" (63-9243 Rev. D) has the drawings, and was not at hand. The numbers
are those of velodyne_description (VLP-16.urdf.xacro) and of Clearpath's description of it
(clearpath_sensors_description, urdf/velodyne_lidar.urdf.xacro): a radius of 51.6 mm, 71.7 mm high,
the optical centre 37.7 mm above the base. What lies within the outline is drawn by eye.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import ALUMINIUM, GREY, WINDOW
from urdfkit.mesh.solids import Assembly, cylinder, revolved


def build(size: Vector) -> Mesh:
    """The lidar, its middle at the origin; size along x, y, z."""
    x, y, z = size
    radius, low = min(x, y) / 2, -z / 2
    sill, lintel = low + 0.31 * z, low + 0.79 * z
    assembly = Assembly()
    base = revolved(
        [
            (0, low),
            (0.95 * radius, low),
            (radius, low + 0.03 * z),
            (radius, low + 0.10 * z),
            (0.97 * radius, low + 0.10 * z),
            (0.97 * radius, low + 0.12 * z),
            (radius, low + 0.12 * z),
            (radius, sill - 0.03 * z),
            (0.97 * radius, sill),
            (0, sill),
        ]
    )
    cap = revolved(
        [
            (0, lintel),
            (0.97 * radius, lintel),
            (0.97 * radius, low + 0.95 * z),
            (0.90 * radius, low + z),
            (0, low + z),
        ]
    )
    assembly.add(ALUMINIUM, base)
    assembly.add(GREY, cap)
    assembly.add(WINDOW, cylinder(0.945 * radius, sill, lintel))
    return assembly.mesh()
