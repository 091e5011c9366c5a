"""The geoms of a robot in MJCF: shapes, meshes with materials and textures, simpler collisions."""

import os
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

import mujoco
import numpy as np

from urdfkit.core import atomic
from urdfkit.core.spatial import Transform, Vector
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.writers import encode
from urdfkit.output.bundle.meshes import FreeNames
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_pieces import Piece, halved, quaternion
from urdfkit.output.conversion.mjcf_textures import Textures
from urdfkit.output.conversion.options import ConversionOptions
from urdfkit.robot.assets.colours import Colours
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.ros.surface_materials import PLAIN, ModelMaterials, SurfaceMaterial
from urdfkit.text.source import Span

#: Geom groups of visuals, which MuJoCo's viewer shows, and collisions, which it hides.
VISUAL_GROUP, COLLISION_GROUP = 2, 3
#: Relative thickness below which a mesh is flat; it becomes a plate of this thickness in m.
FLAT, THICKNESS = 1e-6, 1e-3
#: Least number of vertices of a mesh that MuJoCo accepts.
_LEAST_VERTICES = 4

KINDS = {
    "box": mujoco.mjtGeom.mjGEOM_BOX,
    "sphere": mujoco.mjtGeom.mjGEOM_SPHERE,
    "cylinder": mujoco.mjtGeom.mjGEOM_CYLINDER,
    "capsule": mujoco.mjtGeom.mjGEOM_CAPSULE,
    "mesh": mujoco.mjtGeom.mjGEOM_MESH,
}
_NO_SIZE = (0.0, 0.0, 0.0)


class Geoms:
    """The geoms, meshes and materials of a specification.

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
        self._spec = spec
        self._robot = robot
        self._files = files
        self._directory = directory
        self._losses = losses
        self._options = options
        self._colours = Colours(robot.model)
        self._materials = ModelMaterials(robot.model, robot.files)
        self._textures = Textures(spec, directory)
        self._meshes: dict[tuple[str, tuple[float, ...], bool], str] = {}
        self._simpler: dict[tuple[str, tuple[float, ...]], tuple[list[Piece], str]] = {}
        self.shapes: dict[int, list[Any]] = {}  # the geoms, by the ``id`` of their element
        self.hulls: list[Body] = []  # collisions that become convex hulls
        self.simpler: set[int] = set()  # elements that become simpler shapes
        self.places: dict[str, Span] = {}  # source locations of meshes, by name
        self._names, self._mesh_names, self._stems = FreeNames(), FreeNames(), FreeNames()
        for file in dict.fromkeys(files.values()):
            self._stems.take(_stem(file))
        self._gazebo = {
            block.get("reference"): block for block in robot.model.gazebo if block.child("material")
        }

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
                note = f"MuJoCo rejects meshes with fewer than {_LEAST_VERTICES} vertices"
                self._losses.lose(geometry.at, note)
                continue
            place = frame @ geometry.origin
            note = "visual geom" if is_visual else "collision geom"
            self._losses.keep(geometry.at, note, "origin", "geometry")
            self._losses.keep(shape.at, note)
            before = len(body.geoms)
            if is_visual:
                self._visual(body, place, link, geometry, Piece(shape.kind, size))
            else:
                pieces = self._collided(geometry, shape, size)
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

    def _visual(
        self, body: Any, frame: Transform, link: Link, geometry: Body, piece: Piece
    ) -> None:
        """Add a geom for each material."""
        assert geometry.shape is not None
        surfaces = [(piece, self._materials.of(link.name, "visual", geometry, None), False)]
        if geometry.shape.filename is not None:
            surfaces = [*self._surfaces(link, geometry, geometry.shape)]
            if len(surfaces) > 1:
                note = f"visual geom for each of its {len(surfaces)} materials"
                self._losses.keep(geometry.shape.at, note)
        for surface_piece, material, has_uv in surfaces:
            geom = self._placed(body, frame, surface_piece, VISUAL_GROUP)
            geom.contype = geom.conaffinity = 0
            self._paint(geom, material, has_uv=has_uv)
        has_uv = all(surface[2] for surface in surfaces)
        self._record_material(link, geometry, surfaces[0][1], has_uv=has_uv)

    def _surfaces(
        self, link: Link, geometry: Body, shape: Shape
    ) -> Iterator[tuple[Piece, SurfaceMaterial, bool]]:
        """Parts of a mesh, with their materials, and whether they have texture coordinates."""
        assert shape.filename is not None
        loaded = self._robot.meshes.mesh(shape)
        file = self._files[id(shape.filename)]
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
                path = self._write(file, f"material_{number}.obj", part_mesh)
            mesh = self._mesh(path, shape, shape.scale, is_visual=True)
            yield Piece("mesh", _NO_SIZE, mesh=mesh), material, has_uv

    def _paint(self, geom: Any, material: SurfaceMaterial, *, has_uv: bool) -> None:
        name = self._textures.material(material) if has_uv else ""
        if name:
            geom.material = name
        elif material != PLAIN:
            geom.rgba = material.rgba

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

    def _collided(self, geometry: Body, shape: Shape, size: tuple[float, ...]) -> Iterable[Piece]:
        """The colliding pieces of a collision."""
        if shape.filename is None:
            return (Piece(shape.kind, size),)
        file = self._files[id(shape.filename)]
        if self._options.collision != "hull":
            key = file, shape.scale
            if key not in self._simpler:
                self._simpler[key] = self._simplified(geometry, shape, file)
            pieces, note = self._simpler[key]
            if pieces:
                self.simpler.add(id(geometry.at))
                self._losses.approximate(shape.at, note)
                return pieces
        plate = self._plate(shape, file)
        if plate:
            note = f"its convex hull, {THICKNESS * 1e3:g} mm thick, as the mesh is flat"
            self.simpler.add(id(geometry.at))
            self._losses.approximate(shape.at, note)
            return (plate,)
        self.hulls.append(geometry)
        mesh = self._mesh(file, shape, shape.scale, is_visual=False)
        return (Piece("mesh", size, mesh=mesh),)

    def _plate(self, shape: Shape, file: str) -> Piece | None:
        """A plate for a flat mesh, of which MuJoCo cannot compute a hull; None for other meshes."""
        vertices = self._robot.meshes.vertices(shape)
        if vertices is None or not len(vertices):
            return None
        _, sizes, axes = np.linalg.svd(vertices - vertices.mean(axis=0), full_matrices=False)
        if sizes[-1] > FLAT * sizes[0]:
            return None
        normal = axes[-1]
        sides = [vertices + side * THICKNESS / 2 * normal for side in (-1, 1)]
        corners = np.concatenate(sides)
        faces = np.resize(np.arange(len(corners)), (-(-len(corners) // 3), 3))  # each in some face
        path = self._write(file, "plate.stl", Mesh((MeshPart(corners, faces),)))
        name = self._mesh(path, shape, is_visual=False)
        self._spec.mesh(name).inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        return Piece("mesh", _NO_SIZE, mesh=name)

    def _simplified(self, geometry: Body, shape: Shape, file: str) -> tuple[list[Piece], str]:
        """Simpler shapes for a mesh, and their description; empty if the mesh is flat."""
        # Its libraries take longer to import than most robots to convert.
        from urdfkit.output.conversion.simpler_collisions import simplified

        simpler = simplified(self._robot, geometry, self._options.collision)
        if simpler is None:
            return [], ""
        if simpler.primitive is not None:
            return [simpler.primitive], simpler.note
        pieces = []
        for number, part in enumerate(simpler.meshes, 1):
            path = self._write(file, f"piece_{number}.stl", part)
            name = self._mesh(path, shape, is_visual=False)
            pieces.append(Piece("mesh", _NO_SIZE, mesh=name))
        return pieces, simpler.note

    def _write(self, file: str, name: str, mesh: Mesh) -> str:
        """Write a new mesh file for a mesh; returns its path."""
        stem, suffix = os.path.splitext(name)
        directory = os.path.dirname(file)
        file_name = self._stems.take(f"{_stem(file)}_{stem}") + suffix
        target_directory = os.path.join(self._directory, directory)
        atomic.make_directory(target_directory)
        for encoded_name, data in encode(mesh, file_name).items():
            atomic.write(os.path.join(target_directory, encoded_name), data, durable=False)
        return f"{directory}/{file_name}" if directory else file_name

    def _mesh(
        self, file: str, shape: Shape, scale: Vector = (1.0, 1.0, 1.0), *, is_visual: bool
    ) -> str:
        """Add a mesh to the specification; returns its name."""
        key = (file, scale, is_visual)
        if key not in self._meshes:
            self._meshes[key] = name = self._mesh_names.take(_stem(file))
            self.places[name] = shape.at.span
            mesh = self._spec.add_mesh(name=name, file=file, scale=scale)
            if is_visual:  # it may be flat
                mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        return self._meshes[key]


def _stem(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]


def _join_small(groups: dict[SurfaceMaterial, list[MeshPart]]) -> None:
    """Join parts that are too small for a mesh with the largest material."""
    counts = {material: _count_vertices(parts) for material, parts in groups.items()}
    largest = max(counts, key=lambda material: counts[material], default=None)
    for material, count in counts.items():
        if largest is not None and count < _LEAST_VERTICES and material != largest:
            for part in groups.pop(material):
                uv = np.zeros((len(part.vertices), 2)) if part.uv is None else part.uv
                groups[largest].append(part._replace(uv=uv))


def has_few_vertices(robot: Context, shape: Shape) -> bool:
    """True for a mesh that is too small for MuJoCo, such as a triangle."""
    mesh = robot.meshes.mesh(shape) if shape.filename else None
    if mesh is None or not 0 < len(mesh.faces) <= _LEAST_VERTICES:
        return False
    return _count_vertices(mesh.parts) < _LEAST_VERTICES


def _count_vertices(parts: Iterable[MeshPart]) -> int:
    """Number of distinct vertices."""
    corners = np.concatenate([part.vertices[part.faces].reshape(-1, 3) for part in parts])
    return len(np.unique(corners, axis=0))


def _size(shape: Shape) -> tuple[float, ...] | None:
    """MuJoCo's size of a shape; None if a size is not positive."""
    if shape.kind == "mesh":
        return _NO_SIZE
    if shape.kind == "box":
        written: tuple[float | None, ...] = shape.size or (None,)
    else:
        written = (shape.radius,) if shape.kind == "sphere" else (shape.radius, shape.length)
    sizes = [size for size in written if size is not None and size > 0]
    return halved(shape.kind, sizes) if len(sizes) == len(written) else None
