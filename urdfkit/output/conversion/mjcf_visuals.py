"""The visual geoms of a robot in MJCF: one for each material, with its colour or texture."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from urdfkit.core.record import Record
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import MeshPart
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_meshes import LEAST_VERTICES, Meshes, count_vertices
from urdfkit.output.conversion.mjcf_pieces import NO_SIZE, Piece
from urdfkit.output.conversion.mjcf_textures import Textures
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.ros.surface_materials import PLAIN, ModelMaterials, SurfaceMaterial


class Surface(Record):
    """A part of a visual with one material."""

    piece: Piece
    material: SurfaceMaterial
    has_uv: bool  # True if it has texture coordinates


class Visuals:
    """The surfaces of visuals, and what becomes of their materials."""

    def __init__(
        self, robot: Context, meshes: Meshes, textures: Textures, losses: LossTable
    ) -> None:
        self._robot = robot
        self._meshes = meshes
        self._textures = textures
        self._losses = losses
        self._colours = Colours(robot.model)
        self._materials = ModelMaterials(robot.model, robot.files)
        self._gazebo = {
            block.get("reference"): block for block in robot.model.gazebo if block.child("material")
        }

    def surfaces(self, link: Link, geometry: Body, shape: Shape, piece: Piece) -> list[Surface]:
        """The surfaces of a visual: those of a mesh, or the piece of another shape."""
        if shape.filename is None:
            material = self._materials.of(link.name, "visual", geometry, None)
            surfaces = [Surface(piece, material, False)]
        else:
            surfaces = list(self._of_mesh(link, geometry, shape))
        if len(surfaces) > 1:
            note = f"visual geom for each of its {len(surfaces)} materials"
            self._losses.keep(shape.at, note)
        has_uv = all(surface.has_uv for surface in surfaces)
        self._record_material(link, geometry, surfaces[0].material, has_uv=has_uv)
        return surfaces

    def _of_mesh(self, link: Link, geometry: Body, shape: Shape) -> Iterator[Surface]:
        loaded = self._robot.meshes.mesh(shape)
        file = self._meshes.file(shape)
        groups: dict[SurfaceMaterial, list[MeshPart]] = {}
        for part in loaded.parts if loaded else ():
            if len(part.faces):
                material = self._materials.of(link.name, "visual", geometry, part.material)
                groups.setdefault(material, []).append(part)
        _join_small(groups)
        if loaded is None or not groups:
            default_material = self._materials.of(link.name, "visual", geometry, None)
            groups = {default_material: []}
        for number, (material, parts) in enumerate(groups.items(), 1):
            has_uv = bool(parts) and all(part.uv is not None for part in parts)
            path = file
            if len(groups) > 1 or (material.texture and has_uv and not file.endswith(".obj")):
                assert loaded is not None
                plain = [part._replace(material=None, colors=None) for part in parts]
                part_mesh = loaded._replace(parts=tuple(plain))
                path = self._meshes.write(file, f"material_{number}.obj", part_mesh)
            mesh = self._meshes.add(path, shape, shape.scale, is_visual=True)
            yield Surface(Piece("mesh", NO_SIZE, mesh=mesh), material, has_uv)

    def _record_material(
        self, link: Link, geometry: Body, used: SurfaceMaterial, *, has_uv: bool
    ) -> None:
        """Record the material of a visual, or of its link in Gazebo."""
        keep = self._losses.keep
        material = self._colours.of(geometry)
        if material is None:
            block = self._gazebo.get(link.name)
            own = self._materials.of(link.name, "visual", geometry, None)
            if block is not None and used == own != PLAIN:
                keep(block, "body")
                keep(block.child("material"), "rgba of the geom")
            return
        if geometry.material and geometry.material.at is not material.at:
            reason = "another material with this name is defined first"
            self._losses.lose(geometry.material.at.child("color"), reason)
            self._losses.lose(geometry.material.at.child("texture"), reason)
        owners = [material, *([geometry.material] if geometry.material else [])]
        if material.rgba:
            for owner in owners:
                keep(owner.at, "rgba of the geom")
            keep(material.at.child("color"), "rgba of the geom")
        if material.texture is not None:
            reason = "" if has_uv else "the shape has no texture coordinates"
            reason = reason or ("" if used.texture else "the image does not exist")
            reason = reason or self._textures.reason(used)
            if reason:
                self._losses.lose(material.at.child("texture"), reason)
                return
            for owner in owners:
                keep(owner.at, "material")
            keep(material.at.child("texture"), "texture")


def _join_small(groups: dict[SurfaceMaterial, list[MeshPart]]) -> None:
    """Join parts that are too small for a mesh with the largest material."""
    counts = {material: count_vertices(parts) for material, parts in groups.items()}
    largest = max(counts, key=lambda material: counts[material], default=None)
    for material, count in counts.items():
        if largest is not None and count < LEAST_VERTICES and material != largest:
            for part in groups.pop(material):
                uv = np.zeros((len(part.vertices), 2)) if part.uv is None else part.uv
                groups[largest].append(part._replace(uv=uv))
