"""The geoms of a robot in MJCF."""

from collections.abc import Iterable, Mapping
from typing import Any

import mujoco

from urdfkit.core.spatial import Transform
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.output.bundle.meshes import FreeNames
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_collisions import Collisions
from urdfkit.output.conversion.mjcf_meshes import LEAST_VERTICES, Meshes, has_few_vertices
from urdfkit.output.conversion.mjcf_pieces import NO_SIZE, Piece, halved, quaternion
from urdfkit.output.conversion.mjcf_textures import Textures
from urdfkit.output.conversion.mjcf_visuals import Surface, Visuals
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.ros.surface_materials import PLAIN

#: Geom groups of visuals, which MuJoCo's viewer shows, and collisions, which it hides.
VISUAL_GROUP, COLLISION_GROUP = 2, 3

KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "mesh": mujoco.mjtGeom.mjGEOM_MESH,
}


class Geoms:
    """Adds the geoms of links to a specification.

    Args:
        files: path of each mesh file, by the ``id`` of the reference.
        directory: base of the paths; new files are added there.
        options: replacement of collision meshes, and whether to add visuals.
    """

    def __init__(
        self,
        spec: Any,
        robot: Context,
        files: Mapping[int, str],
        directory: str,
        losses: LossTable,
        options: ConversionOptions,
    ) -> None:
        self._robot = robot
        self._losses = losses
        self._options = options
        self._textures = Textures(spec, directory)
        self.meshes = Meshes(spec, files, directory)
        self.collisions = Collisions(spec, robot, self.meshes, losses, options.collision)
        self._visuals = Visuals(robot, self.meshes, self._textures, losses)
        self._names = FreeNames()
        self.shapes: dict[int, list[Any]] = {}  # the geoms, by the ``id`` of their element

    def add(self, body: Any, frame: Transform, link: Link) -> list[Any]:
        """Add the geoms of a link.

        Args:
            frame: of the link, in the frame of the body.

        Returns:
            The geoms that collide.

        Raises:
            UrdfkitError: a shape that collides has no size.
        """
        colliding: list[Any] = []
        visuals = link.visuals if self._options.visuals else ()
        for geometry in (*visuals, *link.collisions):
            shape = geometry.shape
            if shape is None or shape.kind not in KINDS:
                continue
            size = _size(shape)
            is_visual = any(geometry is visual for visual in link.visuals)
            if size is None:
                note = f"<{shape.kind}> of link '{link.name}' has no size above 0"
                if not is_visual:
                    raise UrdfkitError(f"{shape.at.span}: {note}; give it a size, or remove it")
                self._losses.lose(geometry.at, note)
                continue
            if is_visual and has_few_vertices(self._robot, shape):
                note = f"MuJoCo rejects meshes with fewer than {LEAST_VERTICES} vertices"
                self._losses.lose(geometry.at, note)
                continue
            place = frame @ geometry.origin
            note = "visual geom" if is_visual else "collision geom"
            self._losses.keep(geometry.at, note, "origin", "geometry")
            self._losses.keep(shape.at, note)
            before = len(body.geoms)
            if is_visual:
                piece = Piece(shape.kind, size)
                for surface in self._visuals.surfaces(link, geometry, shape, piece):
                    self._show(body, place, surface)
            else:
                pieces = self.collisions.pieces(geometry, shape, size)
                colliding += [self._placed(body, place, piece, COLLISION_GROUP) for piece in pieces]
            self.shapes[id(geometry.at)] = body.geoms[before:]
            self._name(geometry, body.geoms[before:])
        return colliding

    def _name(self, geometry: Body, geoms: Iterable[Any]) -> None:
        """Name the geoms of a visual or collision after it, with numbers if the name is taken."""
        written = geometry.at.attributes.get("name")
        if written is None or not written.value:
            return
        self._losses.keep(written, "name of the geom")
        for geom in geoms:
            geom.name = self._names.take(written.value)

    def _placed(self, body: Any, frame: Transform, piece: Piece, group: int) -> Any:
        place = frame @ piece.frame
        geom = body.add_geom(
            type=KINDS[piece.kind],
            pos=place.position,
            quat=quaternion(place.rotation),
            size=piece.size,
            group=group,
        )
        if piece.mesh:
            geom.meshname = piece.mesh
        return geom

    def _show(self, body: Any, place: Transform, surface: Surface) -> None:
        """Add a geom that collides with nothing."""
        geom = self._placed(body, place, surface.piece, VISUAL_GROUP)
        geom.contype = geom.conaffinity = 0
        name = self._textures.material(surface.material) if surface.has_uv else ""
        if name:
            geom.material = name
        elif surface.material != PLAIN:
            geom.rgba = surface.material.rgba


def _size(shape: Shape) -> tuple[float, ...] | None:
    """MuJoCo's size of a shape; None if a size is not positive."""
    if shape.kind == "mesh":
        return NO_SIZE
    if shape.kind == "box":
        written: tuple[float | None, ...] = shape.size or (None,)
    else:
        written = (shape.radius,) if shape.kind == "sphere" else (shape.radius, shape.length)
    sizes = [size for size in written if size is not None and size > 0]
    return halved(shape.kind, sizes) if len(sizes) == len(written) else None
