"""A swivel caster: a plate, a fork that trails, and a wheel.

Sizes of a light furniture caster with a wheel of 50 mm: 70 mm high over all, 18 mm wide, 23 mm
offset. The names of its measures are those of EN 12526.
"""

from __future__ import annotations

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import ALUMINIUM, DARK, GREY, RUBBER
from urdfkit.mesh.solids import Assembly, box, cylinder, extruded, rounded_box


def build(size: Vector) -> Mesh:
    """The caster, its middle at the origin, trailing along -x; size along x, y, z."""
    x, y, z = size
    low, top = -z / 2, z / 2
    radius = min(0.36 * z, 0.37 * x)
    axle = (-x / 2 + radius, low + radius)
    pivot = x / 2 - 0.5 * min(0.52 * x, y)
    tread = 0.5 * y
    assembly = Assembly()
    wheel = cylinder(radius, -tread / 2, tread / 2) - cylinder(0.62 * radius, -y, y)
    hub = cylinder(0.62 * radius, -0.48 * tread, 0.48 * tread)
    pin = cylinder(0.16 * radius, -0.42 * y, 0.42 * y, sides=24)
    cheek = extruded(
        [
            (axle[0] - 0.24 * radius, axle[1] - 0.24 * radius),
            (axle[0] + 0.24 * radius, axle[1] - 0.24 * radius),
            (pivot + 0.20 * x, top - 0.12 * z),
            (pivot - 0.24 * x, top - 0.12 * z),
        ],
        -0.05 * y,
        0.05 * y,
    ).rotate((90, 0, 0))
    bridge_low = max(axle[1] + 1.06 * radius, top - 0.20 * z)
    bridge = box(
        (0.44 * x, 0.74 * y, top - 0.08 * z - bridge_low),
        (pivot - 0.02 * x, 0, (top - 0.08 * z + bridge_low) / 2),
    )
    fork = bridge + cheek.translate((0, 0.34 * y, 0)) + cheek.translate((0, -0.34 * y, 0))
    plate = rounded_box(
        (min(0.52 * x, y), y, 0.05 * z), (pivot, 0, top - 0.025 * z), 0.08 * min(x, y)
    )
    bearing = cylinder(0.20 * min(x, y), top - 0.09 * z, top - 0.05 * z, (pivot, 0), 32)
    across = (90.0, 0.0, 0.0)
    at = (axle[0], 0.0, axle[1])
    assembly.add(RUBBER, wheel.rotate(across).translate(at))
    assembly.add(DARK, pin.rotate(across).translate(at))
    assembly.add(GREY, hub.rotate(across).translate(at))
    assembly.add(ALUMINIUM, plate + bearing + fork)
    return assembly.mesh()
