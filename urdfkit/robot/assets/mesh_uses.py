"""Uses of mesh files in the visuals and collisions of a model."""

from __future__ import annotations

import os

from urdfkit.core.record import Record
from urdfkit.core.spatial import Vector
from urdfkit.mesh.measures import Measures
from urdfkit.robot.inertials.shape_mass import stretched
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.robot.placed import Placed
from urdfkit.robot.shapes import MeshSolid
from urdfkit.text.document import Attribute


class MeshUse(Record):
    """A mesh file in a visual or a collision of a link."""

    at: Placed[str]  # the file name after expansion
    link: Link  # the link
    role: str  # ``visual`` or ``collision``
    body: Body  # the visual or collision
    shape: Shape  # the mesh in it
    path: str  # of the file
    measures: Measures  # of its triangles

    @property
    def who(self) -> str:
        return f"link '{self.link.name}': the {self.role} mesh '{self.at.value}'"

    @property
    def factors(self) -> Vector:
        """Factors along x, y and z from file coordinates to m, as RViz and Gazebo apply them."""
        x, y, z = self.shape.scale
        unit = self.measures.unit
        return (x * unit, y * unit, z * unit)

    @property
    def edges(self) -> Vector:
        """Edge lengths of the bounding box along the axes of the file, in m."""
        x, y, z = (abs(f) * e for f, e in zip(self.factors, self.measures.edges, strict=True))
        return (x, y, z)

    @property
    def longest(self) -> float:
        """The longest edge of the bounding box, in m."""
        return max(self.edges)

    @property
    def points(self) -> tuple[Vector, ...]:
        """The extreme vertices in m, in the frame of the link."""
        x, y, z = self.factors
        apply = self.body.origin.apply
        return tuple(apply((a * x, b * y, c * z)) for a, b, c in self.measures.points)

    @property
    def solid(self) -> MeshSolid | None:
        """The mesh as a solid in the frame of the link; None if it is flat."""
        measures = self.measures
        uniform, hull = measures.solid or measures.hull, measures.hull
        if uniform is None or hull is None:
            return None
        properties = stretched(uniform, self.shape, measures.unit)
        outer = stretched(hull, self.shape, measures.unit)
        if properties is None or outer is None:
            return None
        name, is_closed = os.path.basename(self.path), measures.solid is not None
        mass = properties.moved(self.body.origin)
        return MeshSolid(name, mass, outer.mass, is_closed, self.points)

    @property
    def scale_at(self) -> Attribute | None:
        return self.shape.at.attributes.get("scale")
