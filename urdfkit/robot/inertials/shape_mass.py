"""Mass properties of the shapes of a link at a density of 1 kg/m³.

Primitives are computed in closed form, meshes by exact integrals over their triangles. The convex
hull replaces a mesh that does not enclose a solid; a note states this.
"""

from __future__ import annotations

from collections.abc import Callable

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.mesh.measures import OVERLAP, Measures, Uniform
from urdfkit.robot.inertia import MassProperties, combined, scaled
from urdfkit.robot.link import Body, Link, Shape, Tensor
from urdfkit.robot.shapes import solid

if TYPE_CHECKING:
    Measure = Callable[[Shape], Measures | str]

#: Sources of the volume of a link.
SOURCES = ("auto", "collision", "visual", "hull")


class ShapeMass(Record):
    """Mass properties of shapes."""

    properties: MassProperties  # in the frame of the link; the mass is the volume in m^3
    source: str  # such as ``the collision`` or ``the hull of the visual``
    notes: tuple[str, ...] = ()  # limitations, such as overlapping shapes

    def with_mass(self, mass: float) -> MassProperties:
        """The mass properties with uniform density and a mass in kg."""
        volume, center, tensor = self.properties
        # Squared radii first: the density of a heavy dot may leave the range of floating point.
        return MassProperties(mass, center, Tensor(*(mass * (value / volume) for value in tensor)))


def shape_mass(link: Link, source: str, measures: Measure) -> ShapeMass | str:
    """Mass properties of the shapes of a link, or the reason why they are unknown.

    Args:
        source: one of `SOURCES`; ``auto`` is the collision, or else the visual; ``hull`` uses the
            convex hull of every mesh of these.
        measures: returns the measures of a mesh, or the reason why there are none.
    """
    collisions = (link.collisions, "the collision")
    visuals = (link.visuals, "the visual")
    choices = {"collision": [collisions], "visual": [visuals]}.get(source, [collisions, visuals])
    reason = "no shape"
    for bodies, name in choices:
        if not bodies:
            continue
        result = _enclosed(bodies, name, measures, hull=source == "hull")
        if isinstance(result, ShapeMass):
            return result
        reason = result
    return reason


def _enclosed(
    bodies: tuple[Body, ...], name: str, measures: Measure, *, hull: bool
) -> ShapeMass | str:
    parts: list[MassProperties] = []
    hulls = 0
    overlaps = 0.0
    for body in bodies:
        primitive = solid((body,))
        if primitive is not None:
            parts.append(primitive.properties(primitive.volume))
            continue
        if body.shape is None or body.shape.filename is None:
            return f"a shape of {name} cannot be read"
        measured = measures(body.shape)
        if isinstance(measured, str):
            return f"{name}: '{body.shape.filename.value}' {measured}"
        is_hull = hull or measured.solid is None
        uniform = measured.hull if is_hull else measured.solid
        if uniform is None:
            return f"{name}: all of the mesh lies in a plane"
        properties = stretched(uniform, body.shape, measured.unit)
        if properties is None:
            return f"{name}: the scale of the mesh is zero"
        hulls += is_hull
        overlaps = max(overlaps, 0.0 if is_hull else measured.overlap)
        parts.append(properties.moved(body.origin))
    notes = []
    if hulls and not hull:
        notes.append("a mesh does not enclose a solid; its convex hull is used")
    if overlaps > OVERLAP:
        notes.append(f"pieces of a mesh overlap; up to {100 * overlaps:.0f} % counts twice")
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
