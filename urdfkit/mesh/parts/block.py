"""A plain block with bevelled edges, where nothing says what it stands for."""

from __future__ import annotations

from manifold3d import Manifold

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.parts.palette import GREY
from urdfkit.mesh.solids import assembled, box


def build(size: Vector) -> Mesh:
    """The block, its middle at the origin; size along x, y, z."""
    x, y, z = size
    bevel = 0.06 * min(size)
    slabs = [
        box((x, y - 2 * bevel, z - 2 * bevel)),
        box((x - 2 * bevel, y, z - 2 * bevel)),
        box((x - 2 * bevel, y - 2 * bevel, z)),
    ]
    return assembled([(GREY, Manifold.batch_hull(slabs))])
