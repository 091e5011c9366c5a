"""Compares the robot that MuJoCo reads from a file with the robot that Pinocchio computes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import mujoco
import numpy as np

from urdfkit.core.record import Record
from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.output.conversion.own_dynamics import OwnDynamics
from urdfkit.output.conversion.random_poses import random_poses
from urdfkit.physics.dynamics.robot import MAX_JOINTS, Dynamics
from urdfkit.robot.kinematics import laws, positions
from urdfkit.robot.rigid_bodies import rigid_bodies

#: Random poses that the frames and the dynamics are compared at.
POSES, DYNAMIC_POSES = 100, 10
#: Bounds: of frames in m; of masses, mass matrix and torques relative to the largest entry.
LENGTH, PART = 1e-9, 1e-6
#: Entries below this, in N·m, kg or kg·m², are rounding.
LEAST = 1e-9
#: So is a torque below the weight of the robot on a lever of so many metres.
LEVER = 1e-6
#: Moving joints of the largest robot that is compared; beyond `MAX_JOINTS` with our own dynamics.
MAX_OWN = 1000


class MjcfProof(Record):
    """The largest differences between MuJoCo and the robot."""

    mass: float  # of links that are fixed together, in kg
    frames: float  # of the placement of a link, in m and of entries of its rotation
    #: mass_matrix and gravity: as a part of the largest entry.
    mass_matrix: float
    gravity: float
    link: str  # whose placement differs most
    engine: str = "Pinocchio"  # that MuJoCo is compared with

    @property
    def part(self) -> str:
        return self.link

    @property
    def holds(self) -> bool:
        return self.frames <= LENGTH and max(self.mass, self.mass_matrix, self.gravity) <= PART

    @property
    def agreed(self) -> str:
        what = "masses, frames, mass matrix and gravity torques"
        return f"MuJoCo and {self.engine} agree on {what}"

    @property
    def disagreed(self) -> str:
        return (
            f"MuJoCo and {self.engine} do not agree on the robot: "
            f"frames {self.frames:.2g} m (link '{self.link}'), masses {self.mass:.2g} kg, "
            f"mass matrix {self.mass_matrix:.2g}, gravity torques {self.gravity:.2g}"
        )


def prove(model: Any, robot: Context) -> MjcfProof:
    """Compare a compiled model of MuJoCo with a robot.

    Args:
        model: an ``mujoco.MjModel``; its bodies and joints have the names of the robot's.

    Raises:
        UrdfkitError: the robot has too many joints, or numbers that no robot has.
    """
    moving = sum(joint.kind != "fixed" for joint in robot.model.joints)
    if moving > MAX_OWN:
        raise UrdfkitError(
            f"{robot.model.place()}: {moving} joints move; MJCF is proved for up to {MAX_OWN}; "
            "split the robot, or fix some of them"
        )
    is_large = moving > MAX_JOINTS
    dynamics = OwnDynamics(robot.tree) if is_large else robot.dynamics
    data = mujoco.MjData(model)
    joints = _Coordinates(model, robot, dynamics)
    least_torque = max(LEAST, LEVER * 9.81 * sum(float(mass) for mass in model.body_mass))
    worst = (0.0, "")
    matrix = gravity = 0.0
    named = robot.model.joints_by_name
    drawn = random_poses((named[name] for name in dynamics.columns if name in named), POSES)
    for number, pose in enumerate(drawn):
        joints.set(data, robot, pose)
        mujoco.mj_forward(model, data)
        worst = max(worst, _placed(data, dynamics.placements(pose)))
        if number < DYNAMIC_POSES:
            ours = joints.compared(dynamics.mass_matrix(pose))
            matrix = max(matrix, _part(ours, joints.mass_matrix(data)))
            ours = joints.compared(dynamics.gravity(pose))
            gravity = max(gravity, _part(ours, joints.gravity(data), least_torque))
    engine = "urdfkit" if is_large else "Pinocchio"
    return MjcfProof(_masses(model, robot), worst[0], matrix, gravity, worst[1], engine)


class _Coordinates:
    """Maps MuJoCo's joints to Pinocchio's coordinates; mimic joints move with their leaders.

    Planar and floating joints stay at zero.
    """

    def __init__(self, model: Any, robot: Context, dynamics: Dynamics | OwnDynamics) -> None:
        self._model = model
        joints = robot.model.joints_by_name
        known = laws(joints)
        self._q: dict[str, int] = {}
        self._columns = np.zeros((model.nv, len(dynamics.columns)))
        for number in range(model.njnt):
            name = model.joint(number).name
            if name in joints:
                self._q[name] = model.jnt_qposadr[number]
                leader, factor, _ = known[name]
                if leader in dynamics.columns:
                    column = dynamics.columns.index(leader)
                    self._columns[model.jnt_dofadr[number], column] = factor
        self._is_compared = self._columns.any(axis=0)

    def set(self, data: Any, robot: Context, pose: Mapping[str, float]) -> None:
        """Put the model into a pose."""
        for name, position in positions(robot.tree, pose).items():
            if name in self._q:
                data.qpos[self._q[name]] = position

    def mass_matrix(self, data: Any) -> Floats:
        """MuJoCo's mass matrix in Pinocchio's coordinates, (n, n)."""
        whole = np.zeros((self._model.nv, self._model.nv))
        mujoco.mj_fullM(self._model, data, whole)
        found: Floats = self._columns.T @ whole @ self._columns
        return found

    def gravity(self, data: Any) -> Floats:
        """Torque or force that holds each coordinate against gravity, (nv,), in N·m or N."""
        found: Floats = self._columns.T @ data.qfrc_bias
        return found

    def compared(self, ours: Floats) -> Floats:
        """Pinocchio's values for the coordinates that are compared; the others are 0."""
        mask = self._is_compared
        return ours * (np.outer(mask, mask) if ours.ndim == 2 else mask)


def _placed(data: Any, links: Mapping[str, Floats]) -> tuple[float, str]:
    """The largest difference of a link's placement, and the name of the link."""
    worst = (0.0, "")
    bodies = _bodies(data.model)
    for name, matrix in links.items():
        part = data.body(name) if name in bodies else data.site(name)  # of a link that is merged
        found = np.eye(4)
        found[:3, :3], found[:3, 3] = part.xmat.reshape(3, 3), part.xpos
        worst = max(worst, (float(np.abs(found - matrix).max()), name))
    return worst


def _masses(model: Any, robot: Context) -> float:
    """The largest difference of the mass of links that are fixed together, in kg."""
    differences = [0.0]
    bodies = _bodies(model)
    for group in rigid_bodies(robot.tree):
        if not group.is_ground:
            own = (link.name for link, _ in group.links if link.name in bodies)
            found = sum(float(model.body(name).mass[0]) for name in own)
            differences.append(abs(found - group.mass))
    return max(differences)


def _bodies(model: Any) -> frozenset[str]:
    return frozenset(model.body(number).name for number in range(model.nbody))


def _part(ours: Floats, theirs: Floats, least: float = LEAST) -> float:
    """The largest difference as a part of the largest entry, which counts as ``least`` at least."""
    largest = max(float(np.abs(ours).max(initial=0.0)), least)
    return float(np.abs(ours - theirs).max(initial=0.0)) / largest
