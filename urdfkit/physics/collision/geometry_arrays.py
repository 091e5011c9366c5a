"""The collision geometry of a model as plain arrays, with what would harm coal left out.

coal crashes the process on a hull of points that lie in a plane, or within 1e-80 m, on NaN and
infinity, and on faces that name vertices which are not there; it gives nonsense for bodies without
thickness.
Nothing of that passes here.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.physics.collision.batch_kinematics import matrix
from urdfkit.robot.assets.triangles import Meshes
from urdfkit.robot.model import RobotModel, Shape

#: In m: bodies that are larger, or farther from their link, are left out.
LARGEST = 1e6
#: In m: thinner primitives are made so thick, and smaller meshes left out.
THINNEST = 1e-6


class CollisionArrays(NamedTuple):
    """One ``<collision>``.

    Attributes:
        link: name of its link.
        number: of the element among the collisions of the link, from 0.
        frame: (4, 4), in the frame of the link.
        kind: ``box``, ``sphere``, ``cylinder``, ``capsule`` or ``mesh``.
        size: three sides; radius; radius and length; nothing for a mesh. In m.
        vertices: (n, 3) of a mesh, in m, in its own frame.
        faces: (m, 3) of a mesh.
    """

    link: str
    number: int
    frame: Floats
    kind: str
    size: tuple[float, ...]
    vertices: Floats
    faces: Integers


class OmittedCollision(NamedTuple):
    """A ``<collision>`` that takes no part, and why."""

    link: str
    number: int
    reason: str


NO_VERTICES = np.zeros((0, 3))
NO_FACES = np.zeros((0, 3), dtype=np.int64)


def solids(
    model: RobotModel, meshes: Meshes, *, unit: bool = True
) -> tuple[tuple[CollisionArrays, ...], tuple[OmittedCollision, ...]]:
    """The collision bodies of a model, and those that cannot be used.

    Args:
        model: the robot.
        meshes: its meshes.
        unit: apply the unit that a COLLADA file states, as RViz and Gazebo do; MoveIt and
            Pinocchio take the numbers as metres.
    """
    found: list[CollisionArrays] = []
    omitted: list[OmittedCollision] = []
    for link in model.links_by_name.values():
        for number, body in enumerate(link.collisions):
            made = _made(body.shape, meshes, unit=unit)
            frame = matrix(body.origin)
            if not isinstance(made, str) and np.abs(frame[:3, 3]).max() > LARGEST:
                made = f"it is more than {LARGEST:g} m from its link"
            if isinstance(made, str):
                omitted.append(OmittedCollision(link.name, number, made))
            else:
                found.append(CollisionArrays(link.name, number, frame, *made))
    return tuple(found), tuple(omitted)


_Made = tuple[str, tuple[float, ...], Floats, Integers]


def _made(shape: Shape | None, meshes: Meshes, *, unit: bool) -> _Made | str:
    """Kind, size, vertices and faces of a shape, or why it cannot be used."""
    if shape is None:
        return "it has no geometry"
    if shape.kind == "mesh":
        return _mesh(shape, meshes, unit=unit)
    sizes = {
        "box": shape.size,
        "sphere": (shape.radius,),
        "cylinder": (shape.radius, shape.length),
        "capsule": (shape.radius, shape.length),
    }
    if shape.kind not in sizes:
        return f"<{shape.kind}> is no shape of URDF"
    size = [value for value in sizes[shape.kind] or () if value is not None]
    if not size or len(size) < len(sizes[shape.kind] or ()):
        return "a size is missing or cannot be read"
    if min(size) < 0:
        return "a size is negative"
    if max(size) > LARGEST:
        return f"it is larger than {LARGEST:g} m"
    return shape.kind, tuple(max(value, THINNEST) for value in size), NO_VERTICES, NO_FACES


def _mesh(shape: Shape, meshes: Meshes, *, unit: bool) -> _Made | str:
    mesh = meshes.mesh(shape)
    vertices = meshes.vertices(shape, unit=unit)
    if mesh is None or vertices is None:
        return meshes.reason(shape)
    vertices, faces = _sound(vertices, mesh.faces)
    if not len(faces):
        return "none of its triangles has an area"
    if np.abs(vertices).max() > LARGEST:
        return f"it is larger than {LARGEST:g} m"
    if np.ptp(vertices, axis=0).max() < THINNEST:
        return f"it is smaller than {THINNEST:g} m"
    return "mesh", (), vertices, faces


def _sound(vertices: Floats, faces: Integers) -> tuple[Floats, Integers]:
    """The triangles with an area and finite corners, and the vertices that they use."""
    faces = faces[((faces >= 0) & (faces < len(vertices))).all(axis=1)]
    faces = faces[np.isfinite(vertices[faces]).all(axis=(1, 2))]
    a, b, c = (vertices[faces[:, corner]] for corner in range(3))
    with np.errstate(over="ignore", invalid="ignore"):
        faces = faces[np.any(np.cross(b - a, c - a) != 0, axis=1)]
    used, numbers = np.unique(faces, return_inverse=True)
    return np.ascontiguousarray(vertices[used]), numbers.reshape(-1, 3)
