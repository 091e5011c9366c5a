"""The collision geometry of a model as plain arrays, without geometry that crashes coal.

coal crashes the process on the hull of coplanar points, or of points within 1e-80 m, on NaN and
infinity, and on faces whose vertices do not exist; its results for bodies without thickness are
wrong. Such geometry is omitted.
"""

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers, scaled_normals
from urdfkit.mesh.transforms import homogeneous
from urdfkit.mesh.welding import weld
from urdfkit.physics.collision.bodies import MAX_COORDINATE, THINNEST, primitive_size, why_omitted
from urdfkit.robot.assets.triangles import Meshes
from urdfkit.robot.link import Link, Shape
from urdfkit.robot.model import RobotModel


class CollisionArrays(NamedTuple):
    """One ``<collision>`` as arrays."""

    link: str  # name of its link
    number: int  # index among the collisions of the link
    frame: Floats  # (4, 4), in the frame of the link
    kind: str  # ``box``, ``sphere``, ``cylinder``, ``capsule`` or ``mesh``
    size: tuple[float, ...]  # three sides; radius; radius and length; empty for a mesh. In m
    vertices: Floats  # (n, 3) of a mesh, in m, in its own frame
    faces: Integers  # (m, 3) of a mesh


class OmittedCollision(NamedTuple):
    """A ``<collision>`` that is omitted, and the reason."""

    link: str
    number: int
    reason: str


#: Vertices and faces, or why they cannot be used, by the loaded mesh and its scale.
_Known = dict[tuple[int, tuple[float, ...]], tuple[Floats, Integers] | str]

NO_VERTICES = np.zeros((0, 3))
NO_FACES = np.zeros((0, 3), dtype=np.int64)


def collision_arrays(
    model: RobotModel, meshes: Meshes, *, unit: bool = True
) -> tuple[tuple[CollisionArrays, ...], tuple[OmittedCollision, ...]]:
    """The collision bodies of a model, and the omitted ones; bodies of one mesh share its arrays.

    Args:
        unit: apply the unit of COLLADA files, as RViz and Gazebo do; MoveIt and Pinocchio read
            metres.
    """
    bodies: list[CollisionArrays] = []
    omitted: list[OmittedCollision] = []
    known: _Known = {}
    for link in model.links_by_name.values():
        for number in range(len(link.collisions)):
            body = arrays(link, number, meshes, unit=unit, known=known)
            if isinstance(body, OmittedCollision):
                omitted.append(body)
            else:
                bodies.append(body)
    return tuple(bodies), tuple(omitted)


def arrays(
    link: Link, number: int, meshes: Meshes, *, unit: bool, known: _Known | None = None
) -> CollisionArrays | OmittedCollision:
    """One collision of a link, by its index.

    Args:
        known: the meshes of other collisions, which is updated.

    Other arguments as for `collision_arrays`.
    """
    body = link.collisions[number]
    shape = body.shape
    reason = why_omitted(body)
    if shape is None or reason:
        return OmittedCollision(link.name, number, reason)
    frame = homogeneous(*body.origin)
    if shape.kind != "mesh":
        size = primitive_size(shape)
        return CollisionArrays(link.name, number, frame, shape.kind, size, NO_VERTICES, NO_FACES)
    loaded = meshes.mesh(shape)
    if loaded is None:
        return OmittedCollision(link.name, number, meshes.reason(shape))
    known = {} if known is None else known
    key = id(loaded), shape.scale
    if key not in known:
        known[key] = _mesh(shape, meshes, unit=unit)
    mesh = known[key]
    if isinstance(mesh, str):
        return OmittedCollision(link.name, number, mesh)
    return CollisionArrays(link.name, number, frame, "mesh", (), *mesh)


def _mesh(shape: Shape, meshes: Meshes, *, unit: bool) -> tuple[Floats, Integers] | str:
    """Vertices and faces, or the reason why they cannot be used."""
    mesh = meshes.mesh(shape)
    vertices = meshes.vertices(shape, unit=unit)
    if mesh is None or vertices is None:
        return meshes.reason(shape)
    vertices, faces = _sound(vertices, mesh.faces)
    if not len(faces):
        return "none of its triangles has an area"
    if np.abs(vertices).max() > MAX_COORDINATE:
        return f"it is larger than {MAX_COORDINATE:g} m"
    if np.ptp(vertices, axis=0).max() < THINNEST:
        return f"it is smaller than {THINNEST:g} m"
    return vertices, faces


def _sound(vertices: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """The triangles with an area and finite corners, and their vertices, each once."""
    faces = faces[((faces >= 0) & (faces < len(vertices))).all(axis=1)]
    faces = faces[np.isfinite(vertices[faces]).all(axis=(1, 2))]
    return weld(vertices, faces[np.any(scaled_normals(vertices[faces]) != 0, axis=1)])
