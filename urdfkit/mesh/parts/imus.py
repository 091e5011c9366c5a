"""Inertial measurement units, their middle at the origin, by their outer edges in m.

What lies within the published outline is drawn by eye.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import ALUMINIUM, BLACK, ORANGE
from urdfkit.mesh.solids import assembled, cylinder, extruded, rounded_box

#: Corners of the shaft of the arrow on the lid, as parts of the length and of its width.
_SHAFT = ((-0.2, -1), (0.14, -1), (0.14, 1), (-0.2, 1))


def xsens_mti(size: Vector) -> Mesh:
    """An IMU in the outline of the Xsens MTi (10 and 100 series).

    57 x 42 x 23.5 mm: an orange box on a plate with four holes, the connector behind. Xsens' "MTi
    User Manual" (MT0605P) has its physical properties, and was not at hand; the size is the one
    commonly quoted from it, and nothing else confirms it.
    """
    x, y, z = size
    side, low = min(x, y), -z / 2
    plate = rounded_box((0.95 * x, y, 0.12 * z), (0.025 * x, 0, low + 0.06 * z), 0.05 * side)
    for across in (-0.42, 0.42):
        for along in (-0.36, 0.41):
            hole = (along * x, across * y)
            plate = plate - cylinder(0.045 * side, low - z, low + z, hole, 24)
    lid = rounded_box(
        (0.95 * x, 0.74 * y, 0.86 * z), (0.025 * x, 0, low + 0.55 * z), 0.05 * side, 0.04 * side
    )
    socket = cylinder(0.30 * z, -x / 2, 0.0, (0, 0), 32).rotate((0, 90, 0))
    socket = socket.translate((0, 0, low + 0.5 * z))
    # The arrow on the lid shows which way is x.
    half, top = 0.10 * side, low + z
    head = [(0.30 * x, 0), (0.12 * x, half), (0.12 * x, -half)]
    shaft = [(along * x, side * half / 3) for along, side in _SHAFT]
    arrow = extruded(head, top - 0.04 * z, top) + extruded(shaft, top - 0.04 * z, top)
    return assembled([(BLACK, arrow), (ORANGE, lid), (ALUMINIUM, plate), (BLACK, socket)])
