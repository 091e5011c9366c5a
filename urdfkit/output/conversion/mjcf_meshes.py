"""The meshes of a specification in MJCF, and their files."""

import os
from collections.abc import Iterable, Mapping
from typing import Any

import mujoco
import numpy as np

from urdfkit.core import atomic
from urdfkit.core.spatial import Vector
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.mesh.writers import encode
from urdfkit.output.bundle.meshes import FreeNames
from urdfkit.robot.link import Shape
from urdfkit.text.source import Span

#: Least number of vertices of a mesh that MuJoCo accepts.
LEAST_VERTICES = 4


class Meshes:
    """Adds meshes to a specification, each once.

    Args:
        files: path of each mesh file, by the ``id`` of the reference.
        directory: base of the paths; new files are added there.
    """

    def __init__(self, spec: Any, files: Mapping[int, str], directory: str) -> None:
        self._spec = spec
        self._files = files
        self._directory = directory
        self._added: dict[tuple[str, tuple[float, ...], bool], str] = {}
        self._names, self._stems = FreeNames(), FreeNames()
        self.places: dict[str, Span] = {}  # source locations, by name
        for file in dict.fromkeys(files.values()):
            self._stems.take(_stem(file))

    def file(self, shape: Shape) -> str:
        """The path of the file of a mesh."""
        assert shape.filename is not None
        return self._files[id(shape.filename)]

    def add(
        self, file: str, shape: Shape, scale: Vector = (1.0, 1.0, 1.0), *, is_visual: bool
    ) -> str:
        """Add a mesh; returns its name."""
        key = (file, scale, is_visual)
        if key not in self._added:
            self._added[key] = name = self._names.take(_stem(file))
            self.places[name] = shape.at.span
            mesh = self._spec.add_mesh(name=name, file=file, scale=scale)
            if is_visual:  # it may be flat
                mesh.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
        return self._added[key]

    def write(self, file: str, name: str, mesh: Mesh) -> str:
        """Write a new mesh file for a mesh; returns its path."""
        stem, suffix = os.path.splitext(name)
        directory = os.path.dirname(file)
        file_name = self._stems.take(f"{_stem(file)}_{stem}") + suffix
        target_directory = os.path.join(self._directory, directory)
        atomic.make_directory(target_directory)
        for encoded_name, data in encode(mesh, file_name).items():
            atomic.write(os.path.join(target_directory, encoded_name), data, durable=False)
        return f"{directory}/{file_name}" if directory else file_name


def _stem(path: str) -> str:
    return os.path.splitext(os.path.basename(path))[0]


def has_few_vertices(robot: Context, shape: Shape) -> bool:
    """True for a mesh that is too small for MuJoCo, such as a triangle."""
    mesh = robot.meshes.mesh(shape) if shape.filename else None
    if mesh is None or not 0 < len(mesh.faces) <= LEAST_VERTICES:
        return False
    return count_vertices(mesh.parts) < LEAST_VERTICES


def count_vertices(parts: Iterable[MeshPart]) -> int:
    """Number of distinct vertices."""
    corners = np.concatenate([part.vertices[part.faces].reshape(-1, 3) for part in parts])
    return len(np.unique(corners, axis=0))
