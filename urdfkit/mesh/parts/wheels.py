"""Wheels, which turn about z, and a caster; the middle at the origin, outer edges in m."""

from __future__ import annotations

from math import pi, sqrt

import numpy as np

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import ALUMINIUM, DARK, GREY, RUBBER
from urdfkit.mesh.solids import (
    Point,
    assembled,
    box,
    cylinder,
    extruded,
    revolved,
    ring,
    rounded_box,
)

_SPOKES = 5
_LUGS = 20
_ROLLERS = 9


def wheel(size: Vector) -> Mesh:
    """A wheel: a rubber tyre with a tread on a rim with five spokes.

    The outline is that of the link; the proportions (tyre a fifth of the radius, hub a quarter) are
    those of common robot wheels of 65 to 130 mm, such as Pololu's and Dagu's.
    """
    x, y, width = size
    radius, half = min(x, y) / 2, width / 2
    inner, shoulder = 0.78 * radius, min(0.25 * width, 0.08 * radius)
    tyre = revolved(
        [
            (inner, -0.92 * half),
            (radius - shoulder, -half),
            (radius, -half + shoulder),
            (radius, half - shoulder),
            (radius - shoulder, half),
            (inner, 0.92 * half),
        ],
        3 * _LUGS,
    )
    groove = box((0.07 * radius, 0.04 * radius, 0.42 * width)).translate((radius, 0, 0))
    for half_turn in range(2 * _LUGS):
        height = -0.24 * width if half_turn % 2 else 0.24 * width
        tyre = tyre - groove.rotate((0, 0, 180.0 * half_turn / _LUGS)).translate((0, 0, height))
    rim = revolved(
        [
            (0.70 * radius, -0.86 * half),
            (inner, -0.92 * half),
            (inner, 0.92 * half),
            (0.70 * radius, 0.86 * half),
        ]
    )
    disc = cylinder(0.71 * radius, -0.28 * half, 0.28 * half)
    for cx, cy in ring(_SPOKES, 0.46 * radius, pi / _SPOKES):
        disc = disc - cylinder(0.155 * radius, -half, half, (cx, cy), 32)
    hub = cylinder(0.24 * radius, -0.86 * half, 0.86 * half) - cylinder(0.07 * radius, -half, half)
    bolts = [cylinder(0.025 * radius, 0.0, 0.92 * half, at, 6) for at in ring(5, 0.16 * radius)]
    grey = (rim + disc - cylinder(0.07 * radius, -half, half)) + hub
    return assembled([(RUBBER, tyre), *((DARK, bolt) for bolt in bolts), (GREY, grey)])


def mecanum_wheel(size: Vector) -> Mesh:
    """A mecanum wheel: nine barrel rollers at 45 degrees between two plates.

    The one in front on the right, or behind on the left: seen from above, the upper rollers of the
    four wheels of a robot make an X. 100 mm wide across and 50 mm along the axle, nine rollers, as
    the common 4-inch wheels are made (Nexus Robot 14105 and its like). The barrels follow from the
    geometry: seen along the axle the wheel is round (A. Gfrerrer, "Geometry and kinematics of the
    Mecanum wheel", CAGD 25, 2008).
    """
    x, y, width = size
    radius = min(x, y) / 2
    # Thin enough not to meet its neighbours, which lie 40 degrees further on.
    distance, half = 0.83 * radius, min(0.46 * width * sqrt(2), 0.68 * radius)
    roller = revolved(_barrel(radius, distance, half), 24)
    roller = roller.rotate((45, 0, 0)).translate((distance, 0, 0))
    rollers = [roller.rotate((0, 0, 360 * number / _ROLLERS)) for number in range(_ROLLERS)]
    plate = 0.05 * width
    plates = cylinder(0.84 * radius, -width / 2, width / 2)
    plates = plates - cylinder(radius, plate - width / 2, width / 2 - plate)
    core = cylinder(0.42 * radius, -width / 2, width / 2) - cylinder(0.12 * radius, -width, width)
    for at in ring(6, 0.27 * radius):
        core = core - cylinder(0.05 * radius, -width, width, at, 16)
    plates = plates - cylinder(0.40 * radius, -width, width)
    between = cylinder(2 * radius, plate - width / 2, width / 2 - plate)
    rubber = [(RUBBER, one ^ between) for one in rollers]
    return assembled([*rubber, (GREY, plates), (DARK, core)])


def _barrel(radius: float, distance: float, half: float) -> list[Point]:
    """The profile of a roller of length ``2 * half``: (distance from its axis, along it).

    A point at the angle p of the circle with radius r around the place s of the roller's axis is
    ``hypot(distance + r cos p, (s + r sin p) / sqrt(2))`` away from the axle. The circle is as
    large as can be while all of it stays within the wheel.
    """
    angles = np.linspace(-pi / 2, pi / 2, 181)
    along = np.linspace(-half, half, 13)[:, None]
    a = np.cos(angles) ** 2 + np.sin(angles) ** 2 / 2
    b = 2 * distance * np.cos(angles) + along * np.sin(angles)
    c = distance**2 + along**2 / 2 - radius**2
    circles = ((-b + np.sqrt(b**2 - 4 * a * c)) / (2 * a)).min(axis=1)
    profile = [(float(r), float(s)) for r, s in zip(circles, along[:, 0], strict=True)]
    return [(0.0, -half), *profile, (0.0, half)]


def caster(size: Vector) -> Mesh:
    """A swivel caster: a plate, a fork that trails, and a wheel.

    Sizes of a light furniture caster with a wheel of 50 mm: 70 mm high over all, 18 mm wide, 23 mm
    offset. The names of its measures are those of EN 12526.
    """
    x, y, z = size
    low, top = -z / 2, z / 2
    radius = min(0.36 * z, 0.37 * x)
    axle = (-x / 2 + radius, low + radius)
    pivot = x / 2 - 0.5 * min(0.52 * x, y)
    tread = 0.5 * y
    tyre = cylinder(radius, -tread / 2, tread / 2) - cylinder(0.62 * radius, -y, y)
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
    turning = ((RUBBER, tyre), (DARK, pin), (GREY, hub))
    on_axle = [(material, one.rotate(across).translate(at)) for material, one in turning]
    return assembled([*on_axle, (ALUMINIUM, plate + bearing + fork)])
