"""The colliding geoms of a robot in MJCF: shapes, convex hulls of meshes, or simpler shapes."""

from collections.abc import Iterable
from typing import Any

import mujoco
import numpy as np

from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Mesh, MeshPart
from urdfkit.output.conversion.losses import LossTable
from urdfkit.output.conversion.mjcf_meshes import Meshes
from urdfkit.output.conversion.mjcf_pieces import NO_SIZE, Piece
from urdfkit.robot.link import Body, Shape

#: Relative thickness below which a mesh is flat; it becomes a plate of this thickness in m.
FLAT, THICKNESS = 1e-6, 1e-3


class Collisions:
    """The pieces of collisions.

    Args:
        method: what replaces collision meshes.
    """

    def __init__(
        self, spec: Any, robot: Context, meshes: Meshes, losses: LossTable, method: str
    ) -> None:
        self._spec = spec
        self._robot = robot
        self._meshes = meshes
        self._losses = losses
        self._method = method
        self._simpler: dict[tuple[str, tuple[float, ...]], tuple[list[Piece], str]] = {}
        self.hulls: list[Body] = []  # collisions that become convex hulls
        self.simpler: set[int] = set()  # elements that become simpler shapes

    def pieces(self, geometry: Body, shape: Shape, size: tuple[float, ...]) -> Iterable[Piece]:
        """The colliding pieces of a collision."""
        if shape.filename is None:
            return (Piece(shape.kind, size),)
        file = self._meshes.file(shape)
        if self._method != "hull":
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
        mesh = self._meshes.add(file, shape, shape.scale, is_visual=False)
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
        path = self._meshes.write(file, "plate.stl", Mesh((MeshPart(corners, faces),)))
        name = self._meshes.add(path, shape, is_visual=False)
        self._spec.mesh(name).inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        return Piece("mesh", NO_SIZE, mesh=name)

    def _simplified(self, geometry: Body, shape: Shape, file: str) -> tuple[list[Piece], str]:
        """Simpler shapes for a mesh, and their description; empty if the mesh is flat."""
        # Its libraries take longer to import than most robots to convert.
        from urdfkit.output.conversion.simpler_collisions import simplified

        simpler = simplified(self._robot, geometry, self._method)
        if simpler is None:
            return [], ""
        if simpler.primitive is not None:
            return [simpler.primitive], simpler.note
        pieces = []
        for number, part in enumerate(simpler.meshes, 1):
            path = self._meshes.write(file, f"piece_{number}.stl", part)
            name = self._meshes.add(path, shape, is_visual=False)
            pieces.append(Piece("mesh", NO_SIZE, mesh=name))
        return pieces, simpler.note
