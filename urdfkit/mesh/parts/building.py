"""Parts built of the solids that `parts.json` lists, in mm, and a plain block.

A solid has a ``material``, what is added, what is cut away, and what it lies ``within``. A shape is
a ``box`` (edges; with ``radius`` and ``chamfer``, rounded), a ``cylinder`` (radius, from, to), a
``lathe`` (a profile of distances from z and heights) or a ``prism`` (an outline in x and y, from
``z`` to ``z``). It is rotated about x, y and z, put ``at`` a place, and repeated in a ``ring``
about z. Where solids overlap, the first has the place.
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
    """A part with its middle at the origin, stretched to outer edges in m."""
    solids = disjoint((_material(one["material"]), _solid(one)) for one in part.solids)
    stretch = vector(edge / true / 1000 for edge, true in zip(size, part.size, strict=True))
    return assembled(
        [(one, on_grid(solid.rotate(part.rotate).scale(stretch))) for one, solid in solids]
    )


def block(size: Vector) -> Mesh:
    """A block with bevelled edges, where nothing says what it stands for; size in m."""
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


def _solid(one: dict[str, Any]) -> Manifold:
    found = Manifold.batch_boolean([_shape(shape) for shape in one["add"]], OpType.Add)
    for shape in one.get("cut", ()):
        found = found - _shape(shape)
    return found ^ _shape(one["within"]) if "within" in one else found


def _shape(shape: dict[str, Any]) -> Manifold:
    sides = shape.get("sides", SIDES)
    if "box" in shape:
        found = box(shape["box"])
        if "radius" in shape:
            found = rounded_box(shape["box"], shape["radius"], shape.get("chamfer", 0.0))
    elif "cylinder" in shape:
        radius, low, high = shape["cylinder"]
        found = cylinder(radius, low, high, sides)
    elif "lathe" in shape:
        found = revolved(shape["lathe"], sides)
    else:
        found = extruded(shape["prism"], *shape["z"])
    found = found.rotate(shape.get("rotate", (0, 0, 0))).translate(shape.get("at", (0, 0, 0)))
    count = shape.get("ring", 1)
    copies = [found.rotate((0, 0, 360 * number / count)) for number in range(count)]
    return Manifold.batch_boolean(copies, OpType.Add)
