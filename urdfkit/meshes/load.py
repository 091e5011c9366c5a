"""Mesh files to triangles."""

from __future__ import annotations

import os

import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.meshes.geometry import Material, Mesh, Part


class UnloadableMesh(UrdfkitError):
    """A mesh file that gives no triangles; the text says why."""


def load(path: str | os.PathLike[str]) -> Mesh:
    """The triangles of a mesh file.

    Raises:
        UnloadableMesh: it gives none.
    """
    import trimesh

    try:
        scene = trimesh.load_scene(os.fspath(path), process=False)
    except Exception as error:  # readers of foreign bytes raise anything
        raise UnloadableMesh(f"{path}: {type(error).__name__}: {error}") from error
    parts = []
    for node in scene.graph.nodes_geometry:
        transform, name = scene.graph[node]
        geometry = scene.geometry[name]
        if not isinstance(geometry, trimesh.Trimesh) or not len(geometry.faces):
            continue
        vertices = trimesh.transform_points(geometry.vertices, transform)
        parts.append(Part(np.asarray(vertices, dtype=float), np.asarray(geometry.faces)))
    if not parts:
        raise UnloadableMesh(f"{path}: no triangles")
    return Mesh(tuple(parts))


_ = Material
