"""Dynamics of robots with too many joints for Pinocchio's memory.

Composite rigid bodies (R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6), with
all spatial vectors at the origin of the root: angular parts first.
"""

from collections.abc import Mapping

import numpy as np

from urdfkit.core.spatial import Transform, rotate
from urdfkit.mesh.geometry import Floats
from urdfkit.output.conversion.body_inertia import homogeneous
from urdfkit.robot.kinematics import direction, frames, laws
from urdfkit.robot.rigid_bodies import properties_of
from urdfkit.robot.tree import KinematicTree

_GRAVITY = np.array([0.0, 0.0, 0.0, 0.0, 0.0, 9.81])


class OwnDynamics:
    """The part of `urdfkit.physics.dynamics.robot.Dynamics` that the proof uses.

    Planar and floating joints stay at zero and have no coordinates.
    """

    def __init__(self, tree: KinematicTree) -> None:
        self._tree = tree
        self._laws = laws(tree.model.joints_by_name)
        moving = (joint for joint in tree.model.joints if joint.is_single_dof)
        self._moving = {joint.name: joint for joint in moving}
        self.columns = tuple(name for name, joint in self._moving.items() if not joint.mimic)
        self._numbers = {name: number for number, name in enumerate(self.columns)}
        self._order = tree.below(tree.roots[0].name)

    def placements(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """Homogeneous matrices (4, 4) of the links in the frame of the root."""
        return {name: homogeneous(*frame) for name, frame in frames(self._tree, pose).items()}

    def mass_matrix(self, pose: Mapping[str, float]) -> Floats:
        """The joint-space mass matrix, the root fixed, (nv, nv)."""
        axes, inertias = self._axes(pose), self._composites(pose)
        matrix = np.zeros((len(self.columns), len(self.columns)))
        for name, axis in axes.items():
            child = self._moving[name].child_name
            force = inertias[child] @ axis
            for ancestor in self._tree.path(child):
                if ancestor.name in axes:
                    entry = float(axes[ancestor.name] @ force)
                    self._add(matrix, name, ancestor.name, entry)
                    if ancestor.name != name:
                        self._add(matrix, ancestor.name, name, entry)
        return matrix

    def gravity(self, pose: Mapping[str, float]) -> Floats:
        """Gravity torque or force of each coordinate, (nv,)."""
        inertias = self._composites(pose)
        torques = np.zeros(len(self.columns))
        for name, axis in self._axes(pose).items():
            child, (leader, factor, _) = self._moving[name].child_name, self._laws[name]
            if leader in self._numbers:
                torque = float(axis @ inertias[child] @ _GRAVITY)
                torques[self._numbers[leader]] += factor * torque
        return torques

    def _add(self, matrix: Floats, row: str, column: str, entry: float) -> None:
        """Add an entry of two joints to the entry of their coordinates."""
        (first, left, _), (second, right, _) = self._laws[row], self._laws[column]
        if first in self._numbers and second in self._numbers:
            matrix[self._numbers[first], self._numbers[second]] += left * right * entry

    def _axes(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """Spatial axis of each joint, (6,)."""
        placed, axes = frames(self._tree, pose), {}
        for name, joint in self._moving.items():
            frame = placed[joint.child_name]
            axis = np.array(rotate(frame.rotation, direction(joint)))
            turning = np.concatenate([axis, np.cross(frame.position, axis)])
            sliding = np.concatenate([np.zeros(3), axis])
            axes[name] = turning if joint.is_rotational else sliding
        return axes

    def _composites(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """Composite inertia of each link and its descendants, (6, 6)."""
        placed = frames(self._tree, pose)
        inertias = {}
        for name in self._order:
            inertias[name] = _spatial_inertia(self._tree, name, placed[name])
        for name in reversed(self._order[1:]):
            parent = self._tree.parents[name][0].parent_name
            inertias[parent] = inertias[parent] + inertias[name]
        return inertias


def _spatial_inertia(tree: KinematicTree, link: str, frame: Transform) -> Floats:
    """Spatial inertia of a link, (6, 6)."""
    mass, center, moments = properties_of(tree.model.links_by_name[link], frame)
    x, y, z = center
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    tensor = np.array(moments.rows)
    return np.block(
        [
            [tensor + mass * cross @ cross.T, mass * cross],
            [mass * cross.T, mass * np.eye(3)],
        ]
    )
