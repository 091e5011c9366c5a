"""Builds parts of the solids in `parts.json`, in mm, and a plain block.

A solid has a ``material``, shapes to ``add``, shapes to ``cut``, and a shape that it is clipped to,
``within``. A shape is a ``box`` (edges; with ``radius`` and ``chamfer``, rounded), a ``cylinder``
(radius, from, to), a ``lathe`` (a profile of distances from z and heights) or a ``prism`` (an
outline in x and y, from ``z`` to ``z``). It is rotated about x, y and z, moved to ``at``, and
repeated in a ``ring`` about z. Where solids overlap, the first one remains.
"""

import json
import os
from functools import cache
from typing import Any

from manifold3d import Manifold, OpType

from urdfkit.core.spatial import Vector, vector
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.parts import RealPart
from urdfkit.mesh.solids import (
    SIDES,
    assembled,
    box,
    cylinder,
    disjoint,
    extruded,
    on_grid,
    revolved,
    rounded_box,
)


def built(part: RealPart, size: Vector) -> Mesh:
    """A part centred at the origin, scaled to outer dimensions in m."""
    solids = disjoint((_material(entry["material"]), _solid(entry)) for entry in part.solids)
    stretch = vector(edge / true / 1000 for edge, true in zip(size, part.size, strict=True))
    return assembled(
        (material, on_grid(solid.rotate(part.rotate).scale(stretch))) for material, solid in solids
    )


def block(size: Vector) -> Mesh:
    """A block with bevelled edges, the placeholder for an unknown part; size in m."""
    x, y, z = size
    bevel = 0.12 * min(size)
    slabs = [box((x, y - bevel, z - bevel)), box((x - bevel, y, z - bevel))]
    slabs.append(box((x - bevel, y - bevel, z)))
    return assembled([(_material("grey_metal"), Manifold.batch_hull(slabs))])


@cache
def _colours() -> dict[str, list[float]]:
    with open(os.path.join(os.path.dirname(__file__), "parts.json"), encoding="utf-8") as file:
        colours: dict[str, list[float]] = json.load(file)["materials"]
    return colours


def _material(name: str) -> MeshMaterial:
    red, green, blue = _colours()[name]
    return MeshMaterial(name, (red, green, blue, 1.0))


def _solid(entry: dict[str, Any]) -> Manifold:
    solid = Manifold.batch_boolean([_shape(shape) for shape in entry["add"]], OpType.Add)
    for shape in entry.get("cut", ()):
        solid = solid - _shape(shape)
    return solid ^ _shape(entry["within"]) if "within" in entry else solid


def _shape(shape: dict[str, Any]) -> Manifold:
    sides = shape.get("sides", SIDES)
    if "box" in shape:
        solid = box(shape["box"])
        if "radius" in shape:
            solid = rounded_box(shape["box"], shape["radius"], shape.get("chamfer", 0.0))
    elif "cylinder" in shape:
        radius, low, high = shape["cylinder"]
        solid = cylinder(radius, low, high, sides)
    elif "lathe" in shape:
        solid = revolved(shape["lathe"], sides)
    else:
        solid = extruded(shape["prism"], *shape["z"])
    solid = solid.rotate(shape.get("rotate", (0, 0, 0))).translate(shape.get("at", (0, 0, 0)))
    count = shape.get("ring", 1)
    copies = [solid.rotate((0, 0, 360 * number / count)) for number in range(count)]
    return Manifold.batch_boolean(copies, OpType.Add)
