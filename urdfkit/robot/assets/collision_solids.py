"""Mass properties of collision shapes: primitives and measurable meshes."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core import libraries
from urdfkit.robot.inertia import MassProperties, combined
from urdfkit.robot.link import Body, Link, Tensor
from urdfkit.robot.shapes import MeshSolid, primitive

if TYPE_CHECKING:
    from collections.abc import Callable

    from urdfkit.robot.assets.triangles import Meshes


class CollisionSolids:
    """Collision shapes of links as solids."""

    def __init__(
        self, meshes: Callable[[], Meshes], mesh_solid: Callable[[Body], MeshSolid | None]
    ) -> None:
        self._meshes = meshes
        self._mesh_solid = mesh_solid

    def __call__(self, link: Link, mesh_volume: str) -> MassProperties | None:
        """Mass properties of a link's collisions at 1 kg/m³, in its frame; None if one is unknown.

        Args:
            mesh_volume: ``unsigned`` as in MuJoCo, ``signed``, or empty to reject meshes.
        """
        parts: list[MassProperties] = []
        for body in link.collisions:
            solid = primitive(body)
            if solid is not None:
                parts.append(solid.properties(solid.volume))
                continue
            part = self._mesh(body, mesh_volume)
            if part is None:
                return None
            parts.append(part)
        return combined(parts)

    def _mesh(self, body: Body, mesh_volume: str) -> MassProperties | None:
        if body.shape is None or body.shape.filename is None or not mesh_volume:
            return None
        if libraries.why_unmeasured():
            return None
        if mesh_volume == "signed":
            solid = self._mesh_solid(body)
            return solid.shape_mass if solid and solid.is_closed else None
        return self._unsigned(body)

    def _unsigned(self, body: Body) -> MassProperties | None:
        from urdfkit.mesh.unsigned_solid import unsigned_solid  # loads numpy

        assert body.shape is not None
        meshes = self._meshes()
        mesh, vertices = meshes.mesh(body.shape), meshes.vertices(body.shape, unit=False)
        if mesh is None or vertices is None:
            return None
        uniform = unsigned_solid(vertices, mesh.faces)
        if uniform is None:
            return None
        own = MassProperties(uniform.volume, uniform.center, Tensor(*uniform.tensor))
        return own.moved(body.origin)
