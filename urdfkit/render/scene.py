"""The contents of an image: the triangles of a robot by link, and the frames of the links."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from urdfkit.core.spatial import Transform, Vector, vector
from urdfkit.lint.context import Context
from urdfkit.mesh import geometry
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.mesh.transforms import scaled_part
from urdfkit.render import arrays, primitives
from urdfkit.render.arrays import Bools, Floats, Integers, bounds
from urdfkit.robot import kinematics
from urdfkit.robot.link import Body, Link, Shape
from urdfkit.ros.surface_materials import PLACEHOLDER, Colour, ModelMaterials, SurfaceMaterial

#: Least edge of the placeholder for a missing mesh, as a part of the robot's size.
PLACEHOLDER_SIZE = 0.045

#: Part of that edge below which a shape is invisible.
MIN_VISIBLE = 0.05

#: Number of faces above which they are as small as pixels, and look smooth without normals.
MAX_SMOOTH = 250_000

#: Largest plausible coordinate in m; geometry beyond it is not drawn.
MAX_COORDINATE = 1e6


class SceneItem(NamedTuple):
    """Triangles of one material that move with one link."""

    link: str  # name of the link
    role: str  # ``visual``, ``collision``, or the name of a layer
    label: str  # the name of a mesh file or the kind of a shape
    material: SurfaceMaterial
    vertices: Floats  # (n, 3), in the frame of the link, in m
    faces: Integers  # (m, 3), indices of vertices, counter-clockwise from outside
    normals: Floats | None = None  # (n, 3), unit vectors; None if every face is flat
    uv: Floats | None = None  # (n, 2), texture coordinates with v upwards; None without a texture
    #: (n, 4), vertex colours instead of the colour of the material; None without.
    colors: Floats | None = None

    def moved(self, frame: Transform) -> SceneItem:
        """The item transformed from a frame to its parent."""
        normals = None if self.normals is None else rotated(self.normals, frame)
        return self._replace(vertices=placed(self.vertices, frame), normals=normals)


class MissingMesh(NamedTuple):
    """A mesh that is replaced by a placeholder."""

    link: str  # name of the link
    role: str  # ``visual`` or ``collision``
    filename: str  # of the mesh, as written
    reason: str  # why it cannot be drawn


class Label(NamedTuple):
    """A label in an image."""

    text: str
    link: str  # the frame of the point
    point: Vector  # the labelled point, in m
    of_link: bool = False  # True if it labels the whole link, at its visible pixels
    is_optional: bool = False  # True if it is omitted when the link is hidden or space is missing


class Scene(NamedTuple):
    """A robot in a configuration."""

    items: tuple[SceneItem, ...]
    frames: Mapping[str, Transform]  # frames of the links by name
    missing: tuple[MissingMesh, ...] = ()  # meshes replaced by placeholders
    labels: tuple[Label, ...] = ()
    #: Notes about empty layers and misleading contents, a sentence each.
    notes: tuple[str, ...] = ()
    legend: tuple[tuple[Colour, str], ...] = ()

    def points(self) -> Floats:
        """All vertices in the world, (n, 3), in m; overlays only if there is nothing else."""
        solids = [item for item in self.items if not item.material.overlay]
        points = [placed(item.vertices, self.frames[item.link]) for item in solids or self.items]
        return np.concatenate(points) if points else np.zeros((0, 3), dtype=np.float32)

    def level(self) -> float:
        """The height of the lowest of these points, in m; 0 without points."""
        points = self.points()
        return float(points[:, 2].min()) if len(points) else 0.0


@np.errstate(over="ignore", invalid="ignore")  # for implausible sizes
def build(
    context: Context,
    positions: Mapping[str, float] | None = None,
    roles: tuple[str, ...] = ("visual",),
) -> Scene:
    """The scene of a robot.

    Links without a path to a root have no frame and are omitted.

    Args:
        positions: positions of joints, in rad or m; the others are at 0.
        roles: ``visual``, ``collision`` or both.

    Raises:
        Unavailable: the description cannot be read.
    """
    frames = kinematics.frames(context.tree, positions or {})
    materials = ModelMaterials(context.model, context.files, see_through="visual" in roles)
    meshes = _SmoothMeshes(context)
    items: list[SceneItem] = []
    absent: list[tuple[Link, str, Body, str]] = []
    for link in context.model.links_by_name.values():
        if link.name not in frames or not _is_near(frames[link.name]):
            continue
        for role in roles:
            for body in link.visuals if role == "visual" else link.collisions:
                candidates = map(_plausible, _items(meshes, materials, link.name, role, body))
                valid = [item for item in candidates if item]
                items += valid
                if not valid and body.shape and body.is_mesh:
                    reason = context.meshes.reason(body.shape) or "it has no valid triangles"
                    absent.append((link, role, body, reason))
    roots = {context.tree.root_of[item.link] for item in items}
    note = f"{len(roots)} roots are drawn at the same position: no joint connects them"
    scene = Scene(tuple(items), frames, notes=(note,) if len(roots) > 1 else ())
    return _with_placeholders(scene, context, absent) if absent else scene


def _with_placeholders(
    scene: Scene, context: Context, absent: list[tuple[Link, str, Body, str]]
) -> Scene:
    """The scene with a box for each body whose mesh is missing."""
    min_edge = PLACEHOLDER_SIZE * _reach(scene)
    boxes = (_placeholder(context, link, role, body, min_edge) for link, role, body, _ in absent)
    missing = (
        MissingMesh(link.name, role, _filename(body.shape), reason)
        for link, role, body, reason in absent
    )
    return scene._replace(items=(*scene.items, *boxes), missing=tuple(missing))


class _SmoothMeshes:
    """The meshes of a robot with normals, each computed once: visuals and collisions share them."""

    def __init__(self, context: Context) -> None:
        self._meshes = context.meshes
        self._known: dict[int, Mesh] = {}

    def mesh(self, shape: Shape) -> Mesh | None:
        """The mesh of a shape; normals are computed unless it has some or is very fine."""
        mesh = self._meshes.mesh(shape)
        if mesh is None:
            return None
        if id(mesh) not in self._known:  # ids are unique: the context keeps all meshes
            parts = (part if len(part.faces) > MAX_SMOOTH else shaded(part) for part in mesh.parts)
            self._known[id(mesh)] = mesh._replace(parts=tuple(parts))
        return self._known[id(mesh)]


def _items(
    meshes: _SmoothMeshes, materials: ModelMaterials, link: str, role: str, body: Body
) -> Iterator[SceneItem]:
    """The items of one visual or collision; empty if its mesh is missing."""
    shape = body.shape
    if shape is None or not _is_near(body.origin):
        return
    if shape.kind == "mesh":
        mesh = meshes.mesh(shape)
        if mesh is None:
            return
        label = os.path.basename(_filename(shape))
        for part in mesh.parts:
            material = materials.of(link, role, body, part.material)
            scale = np.array(shape.scale, dtype=np.float64) * mesh.unit
            yield _part(link, role, label, material, part, scale).moved(body.origin)
        return
    triangles = _primitive(shape)
    if triangles is not None:
        material = materials.of(link, role, body, None)
        yield SceneItem(link, role, shape.kind, material, *triangles).moved(body.origin)


def _is_near(frame: Transform) -> bool:
    return all(abs(part) < MAX_COORDINATE for part in frame.position)


def _plausible(item: SceneItem) -> SceneItem | None:
    """An item without implausibly far vertices, whose faces are omitted, and unused vertices."""
    faces, vertices = item.faces, item.vertices
    good: Bools = np.abs(vertices).max(axis=1) < MAX_COORDINATE
    if not good.all():
        faces = faces[good[faces].all(axis=1)]
    if not len(faces):
        return None
    used = np.zeros(len(vertices), dtype=bool)
    used[faces] = True
    vertices = np.where(used[:, None], vertices, vertices[faces[0, 0]])
    return item._replace(vertices=vertices, faces=faces)


def _part(
    link: str,
    role: str,
    label: str,
    material: SurfaceMaterial,
    part: MeshPart,
    scale: geometry.Floats,
) -> SceneItem:
    """A part of a mesh, scaled."""
    vertices, faces, _, normals, uv, colors = scaled_part(part, scale)
    return SceneItem(
        link,
        role,
        label,
        material,
        vertices.astype(np.float32),
        faces.astype(np.int32),
        None if normals is None else normals.astype(np.float32),
        None if uv is None else uv.astype(np.float32),
        None if colors is None else colors.astype(np.float32),
    )


def _primitive(shape: Shape) -> primitives.Triangles | None:
    """The triangles of a shape; None for a shape without a size or not of URDF."""
    if shape.kind == "box" and shape.size:
        return primitives.box(*shape.size)
    if shape.kind == "sphere" and shape.radius is not None:
        return primitives.sphere(shape.radius)
    if shape.radius is not None and shape.length is not None:
        if shape.kind == "cylinder":
            return primitives.cylinder(shape.radius, shape.length)
        if shape.kind == "capsule":
            return primitives.capsule(shape.radius, shape.length)
    return None


def _placeholder(context: Context, link: Link, role: str, body: Body, min_edge: float) -> SceneItem:
    """A marked box instead of a mesh.

    It is as large as another shape or mesh of the link, or else extends to the joints of its child
    links.
    """
    size, frame = _placeholder_box(context, link, body, min_edge)
    edges = np.array(size, dtype=np.float32)
    vertices, faces, _, uv = primitives.box(*size)
    assert uv is not None
    side = np.arange(6) % 3  # the stripes are as wide and as steep on every side
    shown = np.stack((edges[(side + 1) % 3], edges[(side + 2) % 3]), axis=1)
    uv = (uv.reshape(6, 4, 2) * (shown / max(edges.max(), 1e-9))[:, None]).reshape(-1, 2)
    label = f"missing: {os.path.basename(_filename(body.shape))}"
    return SceneItem(link.name, role, label, PLACEHOLDER, vertices, faces, None, uv).moved(frame)


def _placeholder_box(
    context: Context, link: Link, body: Body, min_edge: float
) -> tuple[Vector, Transform]:
    """The edges of the placeholder of a mesh, in m, and the frame of its middle in the link."""
    bodies = (*link.collisions, *link.visuals)
    halves = [other.shape.half_extents for other in bodies if other.shape]
    # A speck usually disables collisions and does not show the size of the mesh.
    speck = MIN_VISIBLE * min_edge
    known = next((half for half in halves if half and speck < max(half) < MAX_COORDINATE), None)
    if known:
        x, y, z = known
        return (2 * x, 2 * y, 2 * z), body.origin
    extents = (_extent(context, other) for other in bodies)
    if around := next((ends for ends in extents if ends), None):
        lowest, highest = around
        edges = highest - lowest
    else:
        origins = (joint.origin for joint in context.tree.children[link.name])
        near = (origin.position for origin in origins if _is_near(origin))
        ends = np.array([(0.0, 0.0, 0.0), *near])
        lowest, highest = ends.min(axis=0), ends.max(axis=0)
        edges = np.maximum(highest - lowest, min_edge)
    return vector(edges), Transform(position=vector((lowest + highest) / 2))


def _extent(context: Context, body: Body) -> tuple[Floats, Floats] | None:
    """The least and the greatest coordinates of a mesh in its link; None if it is missing."""
    if body.shape is None or body.shape.kind != "mesh":
        return None
    vertices = context.meshes.vertices(body.shape)
    if vertices is None:
        return None
    lowest, highest = bounds(placed(vertices.astype(np.float32), body.origin))
    return (lowest, highest) if np.abs((lowest, highest)).max() < MAX_COORDINATE else None


def _reach(scene: Scene) -> float:
    """The size of the geometry and frames of a robot, in m."""
    near = [frame.position for frame in scene.frames.values() if _is_near(frame)]
    places = arrays.single(near)
    points = np.concatenate((scene.points(), places))
    reach = float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) else 0.0
    return reach or 1.0


def _filename(shape: Shape | None) -> str:
    return shape.filename.value if shape and shape.filename else ""


def placed(points: Floats, frame: Transform) -> Floats:
    """Points (n, 3), transformed from a frame to its parent."""
    return np.asarray(rotated(points, frame) + arrays.single([frame.position]))


def rotated(vectors: Floats, frame: Transform) -> Floats:
    """Directions (n, 3), transformed from a frame to its parent."""
    return arrays.rotated(vectors, np.asarray(frame.rotation))
