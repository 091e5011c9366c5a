"""The mass properties of a robot: declared and computed from the shapes, per link and in total."""

from __future__ import annotations

from collections.abc import Mapping

from urdfkit.core.record import Record
from urdfkit.core.spatial import Rotation, Transform, Vector
from urdfkit.lint.context import Context
from urdfkit.robot.bounding_box import without_meshes
from urdfkit.robot.composite_body import CompositeBody, composite_body
from urdfkit.robot.inertia import MassProperties, principal_axes
from urdfkit.robot.inertials.shape_mass import ShapeMass, shape_mass
from urdfkit.robot.kinematics import frames
from urdfkit.robot.link import Link
from urdfkit.robot.rigid_bodies import properties_of


class MassRow(Record):
    """Mass properties of a link."""

    link: str  # name
    properties: MassProperties  # as declared, in the frame of the link
    moments: Vector  # principal moments, smallest first, in kg·m²
    axes: Rotation  # a rotation whose columns are their axes, in the frame of the link
    shape_mass: ShapeMass | None  # of the volume that its shapes enclose; None if unknown
    reason: str  # why it is unknown; empty if it is known

    @property
    def density(self) -> float | None:
        """The declared mass divided by the volume of the shapes, in kg/m³; None without volume."""
        volume = self.shape_mass.properties.mass if self.shape_mass else 0.0
        return self.properties.mass / volume if volume > 0 else None

    @property
    def of_shapes(self) -> tuple[Vector, Rotation] | None:
        """Principal moments and axes of the shapes with the declared mass, uniformly dense."""
        if self.shape_mass is None or not self.shape_mass.properties.mass > 0:
            return None
        return principal_axes(self.shape_mass.with_mass(self.properties.mass).tensor)


class MassTable(Record):
    """Mass properties of all links with a mass or a shape, and of the robot."""

    rows: tuple[MassRow, ...]  # in the order of the document
    whole: CompositeBody  # the robot as one rigid body at a pose
    #: moments and axes: of the whole, as for a link; None without properties.
    moments: Vector | None
    axes: Rotation | None


def mass_properties(context: Context, pose: Mapping[str, float] | None = None) -> MassTable:
    """Masses, centres of mass and inertias of the links, and of the whole robot in a pose.

    Args:
        context: the robot.
        pose: positions of joints in rad or m, for the whole; the others are at 0.
    """
    links = context.model.links_by_name.values()
    robot_body = composite_body(context.tree, frames(context.tree, pose or {}))
    body = robot_body.properties
    moments, axes = principal_axes(body.tensor) if body else (None, None)
    rows = [_row(context, link) for link in links if not link.is_frame]
    return MassTable(tuple(rows), robot_body, moments, axes)


def _row(context: Context, link: Link) -> MassRow:
    properties = properties_of(link, Transform())
    moments, axes = principal_axes(properties.tensor)
    try:
        measured = shape_mass(link, "auto", context.measures)
    except ImportError:
        measured = without_meshes()
    if isinstance(measured, str):
        return MassRow(link.name, properties, moments, axes, None, measured)
    return MassRow(link.name, properties, moments, axes, measured, "")
