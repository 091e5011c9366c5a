"""Triangles of the mesh files of a model; each file is loaded once."""

from __future__ import annotations

import os

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.robot.link import Shape

if TYPE_CHECKING:
    from urdfkit.core.progress import Progress
    from urdfkit.mesh.geometry import Floats, Mesh
    from urdfkit.robot.assets.mesh_files import MeshFiles


class Meshes:
    """The meshes of one model.

    Args:
        progress: called with the number of loaded files and the total number.
    """

    def __init__(self, files: MeshFiles, progress: Progress | None = None) -> None:
        self._files = files
        self._progress = progress
        self._loaded: dict[str, Mesh | str] = {}

    def mesh(self, shape: Shape) -> Mesh | None:
        """The mesh in the file of a shape, in the file's units; None if it cannot be loaded."""
        loaded = self._load(shape)
        return None if isinstance(loaded, str) else loaded

    def reason(self, shape: Shape) -> str:
        """The reason why a shape has no triangles; empty for a loadable mesh."""
        loaded = self._load(shape)
        return loaded if isinstance(loaded, str) else ""

    def vertices(self, shape: Shape, *, unit: bool = True) -> Floats | None:
        """The vertices of a shape in m, (n, 3), in the frame of its visual or collision.

        Args:
            unit: apply the unit of length that a COLLADA file states, as RViz and Gazebo do;
                Pinocchio, coal and MoveIt do not.
        """
        mesh = self.mesh(shape)
        if mesh is None:
            return None
        factor = mesh.unit if unit else 1.0
        x, y, z = shape.scale
        return mesh.scaled((x * factor, y * factor, z * factor))

    def _load(self, shape: Shape) -> Mesh | str:
        if shape.filename is None:
            return f"its <{shape.kind}> has no size, or an implausible one"
        path = self._files.path(shape)
        if path is None:
            return "the file is missing"
        if path not in self._loaded:
            from urdfkit.mesh.io.load import UnloadableMesh, load

            if self._progress:
                self._progress(len(self._loaded), len(self._files.paths))
            try:
                self._loaded[path] = load(path)
            except UnloadableMesh as error:
                self._loaded[path] = f"{os.path.basename(path)} {error.reason}"
        return self._loaded[path]
