"""Dynamics of robots with too many joints for Pinocchio's memory.

Composite rigid bodies (R. Featherstone, "Rigid Body Dynamics Algorithms", 2008, chapter 6), with
all spatial vectors at the origin of the root: angular parts first.
"""

from collections.abc import Mapping

import numpy as np

from urdfkit.core.spatial import Transform, cross, rotate
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
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
        self._joints = [joint for joint in tree.model.joints if joint.is_single_dof]
        self.columns = tuple(joint.name for joint in self._joints if not joint.mimic)
        known = laws(tree.model.joints_by_name)
        followed = [known[joint.name] for joint in self._joints]
        factors = [[law.factor * (law.leader == name) for name in self.columns] for law in followed]
        #: (n, nv), maps velocities of ``columns`` to velocities of the moving joints.
        self._selection = np.reshape(factors, (len(self._joints), len(self.columns)))
        paths = [{above.name for above in tree.path(joint.child_name)} for joint in self._joints]
        #: (n, n), True if the second joint is above the first, or the same.
        self._is_above = np.array(
            [[joint.name in path for joint in self._joints] for path in paths]
        )

    def placements(self, pose: Mapping[str, float]) -> dict[str, Floats]:
        """Homogeneous matrices (4, 4) of the links in the frame of the root."""
        return {name: homogeneous(*frame) for name, frame in frames(self._tree, pose).items()}

    def mass_matrix(self, pose: Mapping[str, float]) -> Floats:
        """The joint-space mass matrix, the root fixed, (nv, nv)."""
        axes = self._axes(pose)
        momenta = np.einsum("nij,nj->ni", self._carried_inertias(pose), axes)
        lower = np.where(self._is_above, momenta @ axes.T, 0.0)
        full = lower + lower.T - np.diag(np.diag(lower))
        return np.asarray(self._selection.T @ full @ self._selection)

    def gravity(self, pose: Mapping[str, float]) -> Floats:
        """Gravity torque or force of each coordinate, (nv,)."""
        forces = self._carried_inertias(pose) @ _GRAVITY
        return np.asarray(self._selection.T @ (self._axes(pose) * forces).sum(axis=1))

    def _axes(self, pose: Mapping[str, float]) -> Floats:
        """Spatial axis of each moving joint, (n, 6)."""
        placed, axes = frames(self._tree, pose), np.zeros((len(self._joints), 6))
        for row, joint in zip(axes, self._joints, strict=True):
            frame = placed[joint.child_name]
            axis = rotate(frame.rotation, direction(joint))
            if joint.is_rotational:
                row[:3], row[3:] = axis, cross(frame.position, axis)
            else:
                row[3:] = axis
        return axes

    def _carried_inertias(self, pose: Mapping[str, float]) -> Floats:
        """Composite inertia of all that each moving joint carries, (n, 6, 6)."""
        placed, tree = frames(self._tree, pose), self._tree
        inertias = {name: _spatial_inertia(tree, name, frame) for name, frame in placed.items()}
        for name in reversed(tree.below(tree.roots[0].name)[1:]):
            inertias[tree.parents[name][0].parent_name] += inertias[name]
        carried = [inertias[joint.child_name] for joint in self._joints]
        return np.reshape(carried, (len(carried), 6, 6))


def _spatial_inertia(tree: KinematicTree, link: str, frame: Transform) -> Floats:
    """Spatial inertia of a link, (6, 6)."""
    mass, center, moments = properties_of(tree.model.links_by_name[link], frame)
    x, y, z = center
    skew = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    tensor = np.array(moments.rows) + mass * skew @ skew.T
    return np.block([[tensor, mass * skew], [mass * skew.T, mass * np.eye(3)]])
