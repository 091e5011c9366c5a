"""Meshes of known shape, for tests."""

import numpy as np
import trimesh

from urdfkit.mesh.geometry import Mesh, MeshMaterial, MeshPart


def as_mesh(shape: trimesh.Trimesh, material: MeshMaterial | None = None) -> Mesh:
    return Mesh((as_part(shape, material),))


def as_part(shape: trimesh.Trimesh, material: MeshMaterial | None = None) -> MeshPart:
    return MeshPart(np.array(shape.vertices), np.array(shape.faces, dtype=np.int64), material)


def as_trimesh(mesh: Mesh) -> trimesh.Trimesh:
    """All parts together, welded."""
    whole = trimesh.Trimesh(mesh.vertices, mesh.faces, process=False)
    whole.merge_vertices(merge_norm=True, merge_tex=True)
    return whole


def cube(size: float = 1.0) -> Mesh:
    return as_mesh(trimesh.creation.box((size, size, size)))
