"""A 2D lidar in the outline of the Slamtec RPLIDAR A2.

76 mm wide and 41 mm high: a flat base and a head that turns on it, with two windows in front.
Slamtec's "RPLIDAR A2 Introduction and Datasheet" (A2M8, rev. 2.5) has a drawing of it, and was not
at hand; the size is the one commonly quoted. Ekumen's mesh of it (andino_description,
meshes/sensors/rplidar-a2.stl) takes up 75 x 40.8 mm, and 4 mm more for its socket.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import BLACK, DARK, GLASS, GREY
from urdfkit.mesh.solids import Assembly, box, revolved


def build(size: Vector) -> Mesh:
    """The lidar, its middle at the origin; size along x, y, z."""
    x, y, z = size
    radius, low = min(x, y) / 2, -z / 2
    seam = low + 0.45 * z
    assembly = Assembly()
    base = revolved(
        [
            (0, low),
            (0.93 * radius, low),
            (radius, low + 0.08 * z),
            (radius, seam - 0.02 * z),
            (0, seam - 0.02 * z),
        ]
    )
    gap = revolved(
        [(0, seam - 0.02 * z), (0.90 * radius, seam - 0.02 * z), (0.90 * radius, seam), (0, seam)]
    )
    head = revolved(
        [
            (0, seam),
            (radius, seam),
            (radius, low + 0.90 * z),
            (0.92 * radius, low + z),
            (0, low + z),
        ]
    )
    middle = low + 0.72 * z
    for side in (0.38, -0.30):
        window = box(
            (0.5 * radius, 0.42 * radius, 0.30 * z), (0.85 * radius, side * radius, middle)
        )
        assembly.add(GLASS, window ^ head)
    assembly.add(BLACK, head)
    assembly.add(GREY, gap)
    assembly.add(DARK, base)
    return assembly.mesh()
