"""Rigid transforms and scaling of meshes."""

import numpy as np
from numpy.typing import ArrayLike

from urdfkit.core.spatial import Transform, Vector
from urdfkit.mesh.geometry import Floats, Mesh, MeshPart


def homogeneous(rotation: ArrayLike, position: ArrayLike) -> Floats:
    """Homogeneous matrix, (4, 4), of a rotation (3, 3) and a position (3,)."""
    matrix = np.eye(4)
    matrix[:3, :3], matrix[:3, 3] = rotation, position
    return matrix


def moved(mesh: Mesh, frame: Transform) -> Mesh:
    """A mesh transformed from a frame to its parent frame."""
    rows, position = np.asarray(frame.rotation), np.asarray(frame.position)
    return mesh._replace(
        parts=tuple(
            part._replace(
                vertices=part.vertices @ rows.T + position,
                normals=None if part.normals is None else part.normals @ rows.T,
            )
            for part in mesh.parts
        )
    )


def scaled(mesh: Mesh, factors: Vector) -> Mesh:
    """A mesh scaled along x, y and z; a mirrored mesh keeps its outside.

    Args:
        factors: not zero.
    """
    stretch = np.asarray(factors, dtype=float)
    return mesh._replace(parts=tuple(scaled_part(part, stretch) for part in mesh.parts))


def scaled_part(part: MeshPart, stretch: Floats) -> MeshPart:
    """A part scaled along x, y and z, (3,); a factor may be zero."""
    normals, mirrored = part.normals, np.prod(np.sign(stretch)) < 0
    if normals is not None:
        # Normalised to about 1 first, and not too small, so that squares do not overflow.
        ratio = np.where(stretch == 0, 1.0, stretch / (np.abs(stretch).max() or 1.0))
        normals = normals / np.copysign(np.maximum(np.abs(ratio), 1e-100), ratio)
        lengths = np.linalg.norm(normals, axis=1, keepdims=True)
        normals = normals / np.where(lengths > 0, lengths, 1.0)
    faces = part.faces[:, ::-1].copy() if mirrored else part.faces
    with np.errstate(over="ignore"):  # infinite coordinates are rejected when the mesh is written
        vertices = part.vertices * stretch
    return part._replace(vertices=vertices, faces=faces, normals=normals)


def in_metres(mesh: Mesh) -> Mesh:
    """A mesh in metres: its unit of length is applied, as in RViz and Gazebo."""
    if mesh.unit == 1.0:
        return mesh
    return scaled(mesh, (mesh.unit,) * 3)._replace(unit=1.0)


def upright(mesh: Mesh) -> Mesh:
    """A mesh rotated so that its up axis is z.

    RViz and Gazebo do not rotate COLLADA, Bullet and Blender do; Gazebo does not rotate glTF, RViz
    does since 15.1.4. Written as COLLADA, OBJ or STL, the result is the same in all programs.
    """
    rows = {
        "Y_UP": ((1.0, 0.0, 0.0), (0.0, 0.0, -1.0), (0.0, 1.0, 0.0)),
        "X_UP": ((0.0, -1.0, 0.0), (0.0, 0.0, -1.0), (1.0, 0.0, 0.0)),
    }.get(mesh.up_axis)
    if rows is None:
        return mesh
    return moved(mesh, Transform(rows))._replace(up_axis="Z_UP")
