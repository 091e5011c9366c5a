"""An industrial camera with a C-mount lens.

A cube of 29 mm with a lens of 26 mm before it. Sources: the 29 x 29 mm housing is the common size
of small machine vision cameras (FLIR Blackfly S, Basler ace), and that of Clearpath's mesh of the
former (clearpath_sensors_description, meshes/flir_blackfly.stl); the C-mount's thread is 1 inch
wide and its flange 17.526 mm before the image.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import BLACK, DARK, GLASS, GREY
from urdfkit.mesh.solids import Assembly, box, revolved, rounded_box


def build(size: Vector) -> Mesh:
    """The camera, its middle at the origin, the lens along x; size along x, y, z."""
    x, y, z = size
    side = min(y, z)
    # Built upright, with the lens along z, and laid down in the end.
    front, seat = x / 2, -x / 2 + 0.53 * x
    radius = 0.43 * side
    assembly = Assembly()
    barrel = revolved(
        [
            (0, seat),
            (0.40 * side, seat),
            (0.40 * side, seat + 0.06 * x),
            (radius, seat + 0.07 * x),
            (radius, seat + 0.17 * x),
            (0.39 * side, seat + 0.18 * x),
            (0.39 * side, seat + 0.26 * x),
            (radius, seat + 0.27 * x),
            (radius, front),
            (0.33 * side, front),
            (0.24 * side, front - 0.07 * x),
            (0, front - 0.07 * x),
        ]
    )
    glass = revolved(
        [
            (0, front - 0.07 * x),
            (0.24 * side, front - 0.07 * x),
            (0.16 * side, front - 0.045 * x),
            (0, front - 0.035 * x),
        ],
    )
    length = seat + x / 2
    housing = rounded_box((z, y, 0.94 * length), (0, 0, seat - 0.47 * length), 0.05 * side)
    back = rounded_box(
        (0.9 * z, 0.9 * y, 0.06 * length), (0, 0, -x / 2 + 0.03 * length), 0.05 * side
    )
    plug = box((0.22 * z, 0.5 * y, 0.04 * length), (0, 0, -x / 2 + 0.02 * length))
    assembly.add(DARK, plug)
    assembly.add(GREY, housing)
    assembly.add(DARK, back)
    assembly.add(GLASS, glass)
    assembly.add(BLACK, barrel)
    laid = Assembly()
    for material, solid in assembly.parts:
        laid.add(material, solid.rotate((0, 90, 0)))
    return laid.mesh()
