"""What an image shows: the triangles of a robot, link by link, and where the links are."""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from typing import NamedTuple

import numpy as np

from urdfkit.core.spatial import Transform, Vector
from urdfkit.lint.context import Context
from urdfkit.mesh import geometry
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.normals import shaded
from urdfkit.mesh.transforms import scaled_part
from urdfkit.render import arrays, primitives
from urdfkit.render.arrays import Bools, Floats, Integers, bounds
from urdfkit.render.materials import PLACEHOLDER, Colour, ModelMaterials, SurfaceMaterial
from urdfkit.robot import kinematics
from urdfkit.robot.model import Body, Link, Shape

#: The least edge of the box that stands for a missing mesh, as a part of the robot.
PLACEHOLDER_SIZE = 0.045

#: What is smaller than this part of that edge is not seen.
SPECK = 0.05

#: Above this number faces are as small as pixels, and flat ones look the same.
MAX_SMOOTH = 250_000

#: In m; what is further away than this, or larger, is a wrong value and not drawn.
LIMIT = 1e6


class SceneItem(NamedTuple):
    """Triangles of one material that move with one link."""

    link: str  # name of the link
    role: str  # ``visual``, ``collision``, or the layer that it belongs to
    label: str  # what it shows: the name of a mesh file or the kind of a shape
    material: SurfaceMaterial  # its colour or texture
    vertices: Floats  # (n, 3), in the frame of the link, in m
    faces: Integers  # (m, 3), indices of vertices, counter-clockwise from outside
    normals: Floats | None = None  # (n, 3), unit vectors; None if every face is flat
    uv: Floats | None = None  # (n, 2), texture coordinates with v upwards; None without a texture
    #: (n, 4), of the vertices, instead of the colour of the material; None without them.
    colors: Floats | None = None

    def moved(self, frame: Transform) -> SceneItem:
        """The same from a frame to its parent."""
        normals = None if self.normals is None else turned(self.normals, frame)
        return self._replace(vertices=placed(self.vertices, frame), normals=normals)


class MissingMesh(NamedTuple):
    """A mesh that a placeholder stands for."""

    link: str  # name of the link
    role: str  # ``visual`` or ``collision``
    filename: str  # of the mesh, as written
    reason: str  # why it cannot be drawn


class Label(NamedTuple):
    """A word in an image."""

    text: str  # the word
    link: str  # in whose frame the point is
    point: Vector  # what it belongs to, in m
    of_link: bool = False  # it belongs to all of the link, wherever that is seen
    is_optional: bool = False  # omitted if the link is hidden or no place is free next to it


class Scene(NamedTuple):
    """A robot in a configuration."""

    items: tuple[SceneItem, ...]  # what there is to draw
    frames: Mapping[str, Transform]  # where each link is, by its name
    missing: tuple[MissingMesh, ...] = ()  # the meshes that placeholders stand for
    labels: tuple[Label, ...] = ()  # words to write
    #: What there was nothing of to draw, or is not as it looks, a sentence each.
    notes: tuple[str, ...] = ()
    legend: tuple[tuple[Colour, str], ...] = ()  # what colours mean

    def points(self) -> Floats:
        """All vertices in the world, (n, 3), in m; of overlays only if there is nothing else."""
        solids = [item for item in self.items if not item.material.overlay]
        found = [placed(item.vertices, self.frames[item.link]) for item in solids or self.items]
        return np.concatenate(found) if found else np.zeros((0, 3), dtype=np.float32)

    def level(self) -> float:
        """The height of the lowest of these points, in m; 0 without one."""
        points = self.points()
        return float(points[:, 2].min()) if len(points) else 0.0


@np.errstate(over="ignore", invalid="ignore")  # of sizes that no robot has
def build(
    context: Context,
    positions: Mapping[str, float] | None = None,
    roles: tuple[str, ...] = ("visual",),
) -> Scene:
    """The scene of a description.

    Links that no root leads to are left out: they are nowhere.

    Args:
        positions: of joints, in rad or m; the others are at 0.
        roles: of ``visual`` and ``collision``, what to show.

    Raises:
        Unavailable: the description cannot be read.
    """
    frames = kinematics.frames(context.tree, positions or {})
    materials = ModelMaterials(context, see_through="visual" in roles)
    meshes = _SmoothMeshes(context)
    items: list[SceneItem] = []
    absent: list[tuple[Link, str, Body, str]] = []
    for link in context.model.links_by_name.values():
        if link.name not in frames or not _is_near(frames[link.name]):
            continue
        for role in roles:
            for body in link.visuals if role == "visual" else link.collisions:
                every = map(_sound, _items(meshes, materials, link.name, role, body))
                found = [item for item in every if item]
                items += found
                if not found and body.shape and body.shape.kind == "mesh":
                    reason = context.meshes.reason(body.shape) or "its triangles are nowhere"
                    absent.append((link, role, body, reason))
    roots = {context.tree.root_of[item.link] for item in items}
    note = f"{len(roots)} roots are drawn in one place: no joint says how they stand to one another"
    scene = Scene(tuple(items), frames, notes=(note,) if len(roots) > 1 else ())
    return _with_placeholders(scene, context, absent) if absent else scene


def _with_placeholders(
    scene: Scene, context: Context, absent: list[tuple[Link, str, Body, str]]
) -> Scene:
    """A box for each body whose mesh is missing; of each its link, role and the reason."""
    least = PLACEHOLDER_SIZE * _reach(scene)
    boxes = (_placeholder(context, link, role, body, least) for link, role, body, _ in absent)
    missing = (
        MissingMesh(link.name, role, _filename(body.shape), reason)
        for link, role, body, reason in absent
    )
    return scene._replace(items=(*scene.items, *boxes), missing=tuple(missing))


class _SmoothMeshes:
    """The meshes of a robot with normals, each made once: many links collide with their visuals."""

    def __init__(self, context: Context) -> None:
        self._meshes = context.meshes
        self._known: dict[int, Mesh] = {}

    def mesh(self, shape: Shape) -> Mesh | None:
        """The mesh of a shape; smooth where it has no normals and is not as fine as pixels."""
        mesh = self._meshes.mesh(shape)
        if mesh is None:
            return None
        if id(mesh) not in self._known:  # no other has its id: the context keeps all meshes
            parts = (part if len(part.faces) > MAX_SMOOTH else shaded(part) for part in mesh.parts)
            self._known[id(mesh)] = mesh._replace(parts=tuple(parts))
        return self._known[id(mesh)]


def _items(
    meshes: _SmoothMeshes, materials: ModelMaterials, link: str, role: str, body: Body
) -> Iterator[SceneItem]:
    """What one visual or collision shows; nothing if its mesh is not to be had."""
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
    return all(abs(part) < LIMIT for part in frame.position)


def _sound(item: SceneItem) -> SceneItem | None:
    """An item of which every vertex is one of a face, and none is far away.

    A bad or absurd number in a file sends vertices there; their faces are left out.
    """
    faces, vertices = item.faces, item.vertices
    good: Bools = np.abs(vertices).max(axis=1) < LIMIT
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
    """None for a shape that has no size, or is none of URDF's."""
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


def _placeholder(context: Context, link: Link, role: str, body: Body, least: float) -> SceneItem:
    """A marked box where a mesh should be.

    It is as large as another shape or mesh of the link; else it reaches to the joints
    of its child links.
    """
    size, frame = _placeholder_box(context, link, body, least)
    edges = np.array(size, dtype=np.float32)
    vertices, faces, _, uv = primitives.box(*size)
    assert uv is not None
    side = np.arange(6) % 3  # the stripes are as wide and as steep on every side
    shown = np.stack((edges[(side + 1) % 3], edges[(side + 2) % 3]), axis=1)
    uv = (uv.reshape(6, 4, 2) * (shown / max(edges.max(), 1e-9))[:, None]).reshape(-1, 2)
    label = f"missing: {os.path.basename(_filename(body.shape))}"
    return SceneItem(link.name, role, label, PLACEHOLDER, vertices, faces, None, uv).moved(frame)


def _placeholder_box(
    context: Context, link: Link, body: Body, least: float
) -> tuple[Vector, Transform]:
    """The edges of the box that stands for a mesh, in m, and where its middle is in the link."""
    bodies = (*link.collisions, *link.visuals)
    halves = [other.shape.half_extents for other in bodies if other.shape]
    # A speck stands for no collision rather than for the mesh.
    if known := next((half for half in halves if half and SPECK * least < max(half) < LIMIT), None):
        x, y, z = known
        return (2 * x, 2 * y, 2 * z), body.origin
    extents = (_extent(context, other) for other in bodies)
    if around := next((ends for ends in extents if ends), None):
        lowest, highest = around
        edges = highest - lowest
    else:
        origins = (joint.origin for joint in context.tree.children[link.name])
        ends = np.array([(0.0, 0.0, 0.0), *(one.position for one in origins if _is_near(one))])
        lowest, highest = ends.min(axis=0), ends.max(axis=0)
        edges = np.maximum(highest - lowest, least)
    (x, y, z), (a, b, c) = edges.tolist(), ((lowest + highest) / 2).tolist()
    return (x, y, z), Transform(position=(a, b, c))


def _extent(context: Context, body: Body) -> tuple[Floats, Floats] | None:
    """The least and the greatest coordinates of a mesh in its link; None if it is not to be had."""
    if body.shape is None or body.shape.kind != "mesh":
        return None
    vertices = context.meshes.vertices(body.shape)
    if vertices is None:
        return None
    lowest, highest = bounds(placed(vertices.astype(np.float32), body.origin))
    return (lowest, highest) if np.abs((lowest, highest)).max() < LIMIT else None


def _reach(scene: Scene) -> float:
    """The size of what is known of a robot, in m."""
    places = arrays.single([one.position for one in scene.frames.values() if _is_near(one)])
    points = np.concatenate((scene.points(), places))
    reach = float(np.linalg.norm(np.ptp(points, axis=0))) if len(points) else 0.0
    return reach or 1.0


def _filename(shape: Shape | None) -> str:
    return shape.filename.value if shape and shape.filename else ""


def placed(points: Floats, frame: Transform) -> Floats:
    """Points (n, 3) of a frame in its parent."""
    moved: Floats = turned(points, frame) + arrays.single([frame.position])
    return moved


def turned(vectors: Floats, frame: Transform) -> Floats:
    """Directions (n, 3) of a frame in its parent."""
    return arrays.turned(vectors, np.asarray(frame.rotation))
