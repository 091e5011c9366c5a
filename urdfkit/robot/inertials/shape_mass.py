"""What the shapes of a link enclose: volume, centre and moments at a density of 1 kg/m³.

Primitives by closed forms, meshes by exact integrals over their triangles. A mesh that does not
enclose a solid counts with its convex hull, and that is said.
"""

from __future__ import annotations

from collections.abc import Callable

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.mesh.measures import OVERLAP, Measures, Uniform
from urdfkit.robot.inertia import MassProperties, combined, scaled
from urdfkit.robot.model import Body, Link, Shape, Tensor
from urdfkit.robot.shapes import solid

if TYPE_CHECKING:
    Measure = Callable[[Shape], Measures | str]

#: What the volume of a link can be taken from.
SOURCES = ("auto", "collision", "visual", "hull")


class ShapeMass(Record):
    """What some shapes enclose."""

    properties: MassProperties  # in the frame of the link; the mass is the volume in m^3
    source: str  # such as ``the collision`` or ``the hull of the visual``
    notes: tuple[str, ...] = ()  # what a reader should know, such as that shapes may overlap

    def weighing(self, mass: float) -> MassProperties:
        """The same with uniform density and a mass in kg."""
        volume, center, tensor = self.properties
        # Squared radii first: the density of a heavy dot may leave the range of floating point.
        return MassProperties(mass, center, Tensor(*(mass * (each / volume) for each in tensor)))


def shape_mass(link: Link, source: str, measures: Measure) -> ShapeMass | str:
    """What the shapes of a link enclose, or why that is not known.

    Args:
        source: one of `SOURCES`; ``auto`` is the collision, else the visual, and ``hull`` is the
            convex hull of every mesh of those.
        measures: measures a mesh, or says why it cannot: `Context.measures`.
    """
    collisions = (link.collisions, "the collision")
    visuals = (link.visuals, "the visual")
    choices = {"collision": [collisions], "visual": [visuals]}.get(source, [collisions, visuals])
    reason = "it has no shape"
    for bodies, name in choices:
        if not bodies:
            continue
        found = _enclosed(bodies, name, measures, hull=source == "hull")
        if isinstance(found, ShapeMass):
            return found
        reason = found
    return reason


def _enclosed(
    bodies: tuple[Body, ...], name: str, measures: Measure, *, hull: bool
) -> ShapeMass | str:
    parts: list[MassProperties] = []
    hulls = 0
    overlaps = 0.0
    for body in bodies:
        whole = solid((body,))
        if whole is not None:
            parts.append(whole.properties(whole.volume))
            continue
        if body.shape is None or body.shape.filename is None:
            return f"a shape of {name} cannot be read"
        found = measures(body.shape)
        if isinstance(found, str):
            return f"{name}: '{body.shape.filename.value}' {found}"
        is_hull = hull or found.solid is None
        uniform = found.hull if is_hull else found.solid
        if uniform is None:
            return f"{name}: all of the mesh lies in a plane"
        properties = stretched(uniform, body.shape, found.unit)
        if properties is None:
            return f"{name}: the scale of the mesh is zero"
        hulls += is_hull
        overlaps = max(overlaps, 0.0 if is_hull else found.overlap)
        parts.append(properties.moved(body.origin))
    notes = []
    if hulls and not hull:
        notes.append("a mesh encloses no solid, so its convex hull is taken")
    if overlaps > OVERLAP:
        notes.append(f"pieces of a mesh overlap; up to {100 * overlaps:.0f} % is counted too much")
    if len(parts) > 1:
        notes.append(f"{len(parts)} shapes; where they overlap, the volume counts twice")
    return ShapeMass(combined(parts), f"the hull of {name}" if hulls else name, tuple(notes))


def stretched(uniform: Uniform, shape: Shape, unit: float) -> MassProperties | None:
    """A solid after the scale of its shape, which may differ along x, y and z.

    The second moments are ``C = tr(I) / 2 - I``; stretched by ``D = diag(x, y, z)`` they
    become ``|det D| D C D``, and the tensor is again ``tr(C) - C``.
    """
    x, y, z = (factor * unit for factor in shape.scale)
    det = abs(x * y * z)
    if det == 0:
        return None
    ixx, ixy, ixz, iyy, iyz, izz = uniform.tensor
    half = (ixx + iyy + izz) / 2
    xx, yy, zz = (half - ixx) * x * x, (half - iyy) * y * y, (half - izz) * z * z
    tensor = Tensor(yy + zz, ixy * x * y, ixz * x * z, xx + zz, iyz * y * z, xx + yy)
    center: Vector = (uniform.center[0] * x, uniform.center[1] * y, uniform.center[2] * z)
    return MassProperties(uniform.volume * det, center, scaled(tensor, det))
