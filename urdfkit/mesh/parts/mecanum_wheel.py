"""A mecanum wheel: nine barrel rollers at 45 degrees between two plates.

The one in front on the right, or behind on the left: seen from above, the upper rollers of the four
wheels of a robot make an X. 100 mm wide across and 50 mm along the axle, nine rollers, as the
common 4-inch wheels are made (Nexus Robot 14105 and its like). The barrels follow from the
geometry: seen along the axle the wheel is round (A. Gfrerrer, "Geometry and kinematics of the
Mecanum wheel", CAGD 25, 2008).
"""

from __future__ import annotations

from math import degrees, pi, sqrt

import numpy as np
from manifold3d import Manifold

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import DARK, GREY, RUBBER
from urdfkit.mesh.solids import Assembly, Point, cylinder, revolved, ring

_ROLLERS = 9


def build(size: Vector) -> Mesh:
    """The wheel, its middle at the origin, its axle along z; size along x, y, z."""
    x, y, width = size
    radius = min(x, y) / 2
    # Thin enough not to meet its neighbours, which lie 40 degrees further on.
    distance, half = 0.83 * radius, min(0.46 * width * sqrt(2), 0.68 * radius)
    roller = revolved(_barrel(radius, distance, half), 24)
    rollers: list[Manifold] = []
    for number, at in enumerate(ring(_ROLLERS, distance)):
        turn = degrees(2 * pi * number / _ROLLERS)
        rollers.append(roller.rotate((45, 0, 0)).rotate((0, 0, turn)).translate((*at, 0)))
    plate = 0.05 * width
    plates = cylinder(0.84 * radius, -width / 2, -width / 2 + plate) + cylinder(
        0.84 * radius, width / 2 - plate, width / 2
    )
    core = cylinder(0.42 * radius, -width / 2, width / 2) - cylinder(0.12 * radius, -width, width)
    for at in ring(6, 0.27 * radius):
        core = core - cylinder(0.05 * radius, -width, width, at, 16)
    plates = plates - cylinder(0.40 * radius, -width, width)
    assembly = Assembly()
    for one in rollers:
        assembly.add(RUBBER, one ^ cylinder(2 * radius, plate - width / 2, width / 2 - plate))
    assembly.add(GREY, plates)
    assembly.add(DARK, core)
    return assembly.mesh()


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
