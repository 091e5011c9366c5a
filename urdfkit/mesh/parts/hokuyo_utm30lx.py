"""A 2D lidar in the outline of the Hokuyo UTM-30LX.

60 x 60 x 87 mm, black housing, the scan plane in a dark window below the cap. The specification by
Hokuyo (C-42-3615) was not at hand; the size is the one commonly quoted from it. Clearpath's mesh
(clearpath_sensors_description, meshes/hokuyo_utm30.stl) takes up the same, and 20 mm more behind
for the cable outlet, which is left out here. What lies within the outline is drawn by eye.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import BLACK, DARK, GREEN, WINDOW
from urdfkit.mesh.solids import Assembly, box, cylinder, revolved, rounded_box


def build(size: Vector) -> Mesh:
    """The lidar, its middle at the origin; size along x, y, z."""
    x, y, z = size
    side, low = min(x, y), -z / 2
    assembly = Assembly()
    # Between the base and the cap the laser looks out through a window of a slightly conical shape.
    waist, neck = low + 0.52 * z, low + 0.56 * z
    top = low + 0.86 * z
    window = revolved([(0, neck), (0.375 * side, neck), (0.345 * side, top), (0, top)])
    cap = revolved(
        [
            (0, top),
            (0.40 * side, top),
            (0.42 * side, top + 0.02 * z),
            (0.42 * side, low + 0.94 * z),
            (0.36 * side, low + z),
            (0, low + z),
        ]
    )
    collar = cylinder(0.44 * side, waist, neck)
    foot = rounded_box((x, y, 0.06 * z), (0, 0, low + 0.03 * z), 0.06 * side)
    body = rounded_box(
        (0.96 * x, 0.96 * y, waist - low - 0.06 * z),
        (0, 0, (low + 0.06 * z + waist) / 2),
        0.10 * side,
    )
    # Behind, the housing goes up to the cap: the blind sector of 90 degrees.
    spine = box((0.16 * x, 0.34 * y, top - neck), (-0.32 * x, 0, (top + neck) / 2))
    assembly.add(GREEN, box((0.02 * x, 0.10 * y, 0.025 * z), (0.475 * x, 0.12 * y, low + 0.44 * z)))
    assembly.add(DARK, foot + cap)
    assembly.add(BLACK, body + collar + spine)
    assembly.add(WINDOW, window)
    return assembly.mesh()
