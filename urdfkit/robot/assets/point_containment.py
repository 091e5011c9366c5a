"""How deep a point is inside the shapes of a link."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core.spatial import IDENTITY, Transform, Vector, rotate
from urdfkit.robot.ray_casting import exit_from
from urdfkit.robot.shapes import BoundingBox, MeshSolid, Primitive, primitive

if TYPE_CHECKING:
    from collections.abc import Callable, Iterable

    from urdfkit.robot.assets.triangles import Meshes
    from urdfkit.robot.model import Body


class PointContainment:
    """The visuals or collisions of a link, around a point.

    Args:
        bodies: the visuals or collisions.
        lump: measures those that are meshes.
        meshes: their triangles.
    """

    def __init__(
        self, bodies: Iterable[Body], lump: Callable[[Body], MeshSolid | None], meshes: Meshes
    ) -> None:
        self._bodies = bodies
        self._lump = lump
        self._meshes = meshes

    def depths(
        self, point: Vector, directions: list[Vector], begin: float, least: float
    ) -> list[float]:
        """How far the wall is in each direction, in m; 0 where there is none.

        All are 0 if the point is in none of the shapes, or in one whose bounding box is nearer than
        ``least`` in the mean of the directions.

        Args:
            point: in the frame of the link.
            directions: unit vectors in that frame.
            begin: what is nearer than this is no wall, in m.
            least: spares the triangles of meshes that are not so deep, in m.
        """
        found = [0.0] * len(directions)
        for body in self._bodies:
            part = primitive(body) or self._lump(body)
            if part is None or not _may_be_deep(part, point, directions, least):
                continue
            walls = self._of(body, part, point, directions, begin)
            found = [max(one, wall) for one, wall in zip(found, walls, strict=True)]
        return found

    def _of(
        self,
        body: Body,
        part: Primitive | MeshSolid,
        point: Vector,
        directions: list[Vector],
        begin: float,
    ) -> list[float]:
        if isinstance(part, Primitive):
            exits = (exit_from(part, point, direction) for direction in directions)
            return [wall if wall > begin else 0.0 for wall in exits]
        assert body.shape is not None
        mesh, vertices = self._meshes.mesh(body.shape), self._meshes.vertices(body.shape)
        if mesh is None or vertices is None:
            return [0.0] * len(directions)
        from urdfkit.mesh.ray_casting import first_hits

        there = body.origin.inverse
        turned = [rotate(there.rotation, direction) for direction in directions]
        return first_hits(vertices, mesh.faces, there.apply(point), turned, begin)


def _may_be_deep(
    part: Primitive | MeshSolid, point: Vector, directions: list[Vector], least: float
) -> bool:
    """True if the box around a part is so deep about a point."""
    box = _box(part) if isinstance(part, MeshSolid) else part
    depths = [exit_from(box, point, direction) for direction in directions]
    return sum(depths) >= least * len(depths)


def _box(lump: MeshSolid) -> Primitive:
    """The box around a mesh, along the axes of the link."""
    low = [min(x) for x in zip(*lump.points, strict=True)]
    high = [max(x) for x in zip(*lump.points, strict=True)]
    box = BoundingBox((low[0], low[1], low[2]), (high[0], high[1], high[2]))
    return Primitive("box", box.edges, 0.0, 0.0, Transform(IDENTITY, box.center))
