"""A 2D lidar in the outline of the Hokuyo URG-04LX.

50 x 50 x 70 mm: a cube with a drum on it, in which the window runs around. Source: Hokuyo,
https://www.hokuyo-aut.jp/dl/Specifications_URG-04LX_1513063395.pdf, as models quote it that were
made from it; the sheet itself was not at hand. The UST-10LX, its successor, is as large:
Clearpath's mesh of that (hokuyo_ust10.stl) takes up 50 x 70 mm, and 14 mm more behind for the
cables. What lies within the outline is drawn by eye, without the connectors.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import BLACK, DARK, GREY, WINDOW
from urdfkit.mesh.solids import Assembly, box, cylinder, revolved, rounded_box


def build(size: Vector) -> Mesh:
    """The lidar, its middle at the origin; size along x, y, z."""
    x, y, z = size
    side, low = min(x, y), -z / 2
    base, sill, lintel = low + 0.57 * z, low + 0.62 * z, low + 0.84 * z
    assembly = Assembly()
    plate = rounded_box((x, y, 0.05 * z), (0, 0, low + 0.025 * z), 0.05 * side)
    housing = rounded_box(
        (0.97 * x, 0.97 * y, base - low - 0.05 * z),
        (0, 0, (low + 0.05 * z + base) / 2),
        0.08 * side,
    )
    cap = revolved(
        [
            (0, lintel),
            (0.43 * side, lintel),
            (0.43 * side, low + 0.95 * z),
            (0.38 * side, low + z),
            (0, low + z),
        ]
    )
    label = box((0.02 * x, 0.5 * y, 0.16 * z), (0.48 * x, 0, low + 0.30 * z))
    assembly.add(GREY, plate + label)
    assembly.add(BLACK, housing + cylinder(0.45 * side, base, sill))
    assembly.add(
        BLACK, box((0.14 * x, 0.40 * y, lintel - sill), (-0.34 * x, 0, (lintel + sill) / 2))
    )
    assembly.add(DARK, cap)
    assembly.add(WINDOW, cylinder(0.40 * side, sill, lintel))
    return assembly.mesh()
