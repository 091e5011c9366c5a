"""What depth and stereo cameras have in common: a bar with round ends and eyes in its face."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from urdfkit.core.spatial import Vector
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.parts.palette import GLASS
from urdfkit.mesh.solids import Assembly, cylinder, rounded_box


class Lens(NamedTuple):
    """A lens.

    Attributes:
        left: from the middle, as a part of the width of the bar.
        radius: as a part of its height.
    """

    left: float
    radius: float


def bar_camera(
    size: Vector, optical_sensors: Iterable[Lens], body: MeshMaterial, face: MeshMaterial
) -> Mesh:
    """A bar along y that looks along x, its middle at the origin; size along x, y, z."""
    x, y, z = size
    # Built with the face upwards: x of the bar becomes z here, and is laid down in the end.
    end = 0.49 * min(y, z)
    shell = rounded_box((z, y, 0.92 * x), (0, 0, -0.04 * x), end, 0.06 * x)
    front = rounded_box((0.86 * z, y - 0.14 * z, 0.10 * x), (0, 0, 0.43 * x), 0.86 * end, 0.01 * x)
    upright = Assembly()
    for eye in optical_sensors:
        place = (0.0, eye.left * y)
        lens = cylinder(eye.radius * z, 0.38 * x, 0.47 * x, place, 32)
        rim = cylinder(1.25 * eye.radius * z, 0.38 * x, 0.50 * x, place, 32)
        upright.add(GLASS, lens)
        upright.add(body, rim - cylinder(eye.radius * z, 0.30 * x, 0.60 * x, place, 32))
    upright.add(face, front)
    upright.add(body, shell)
    laid = Assembly()
    for material, solid in upright.parts:
        laid.add(material, solid.rotate((0, 90, 0)))
    return laid.mesh()
