"""A wheel: a rubber tyre with a tread on a rim with five spokes.

The outline is that of the link; the proportions (tyre a fifth of the radius, hub a quarter) are
those of common robot wheels of 65 to 130 mm, such as Pololu's and Dagu's.
"""

from __future__ import annotations

from math import pi

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import DARK, GREY, RUBBER
from urdfkit.mesh.solids import Assembly, box, cylinder, revolved, ring

_SPOKES = 5
_LUGS = 20


def build(size: Vector) -> Mesh:
    """The wheel, its middle at the origin, its axis along z; size along x, y, z."""
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
    groove_depth = 0.035 * radius
    for number, (cx, cy) in enumerate(ring(_LUGS, radius)):
        groove = box((2 * groove_depth, 0.04 * radius, 0.42 * width)).translate(
            (0, 0, 0.24 * width)
        )
        other = box((2 * groove_depth, 0.04 * radius, 0.42 * width)).translate(
            (0, 0, -0.24 * width)
        )
        turn = 360.0 * number / _LUGS
        tyre = tyre - groove.rotate((0, 0, turn)).translate((cx, cy, 0))
        step = ring(_LUGS, radius, pi / _LUGS)[number]
        tyre = tyre - other.rotate((0, 0, turn + 180.0 / _LUGS)).translate((*step, 0))
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
    assembly = Assembly()
    assembly.add(RUBBER, tyre)
    for bolt in bolts:
        assembly.add(DARK, bolt)
    assembly.add(GREY, (rim + disc - cylinder(0.07 * radius, -half, half)) + hub)
    return assembly.mesh()
