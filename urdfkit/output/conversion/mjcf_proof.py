"""Compares MuJoCo's model of a converted robot with Pinocchio's model of the robot."""

from collections.abc import Mapping
from copy import copy
from typing import Any

import mujoco
import numpy as np

from urdfkit.errors import UrdfkitError
from urdfkit.lint.context import Context
from urdfkit.mesh.geometry import Floats
from urdfkit.mesh.transforms import homogeneous
from urdfkit.output.conversion.mjcf_comparison import (
    ZERO,
    inertias,
    joints,
    names,
    relative,
    residual,
    shapes,
)
from urdfkit.output.conversion.mjcf_inputs import expected_options
from urdfkit.output.conversion.mjcf_pieces import WrittenShape
from urdfkit.output.conversion.own_dynamics import OwnDynamics
from urdfkit.output.conversion.random_poses import random_poses
from urdfkit.output.conversion.result import Proof
from urdfkit.output.conversion.text_reading import read_text
from urdfkit.physics.dynamics.robot import MAX_JOINTS, Dynamics
from urdfkit.robot.kinematics import laws, positions

#: Number of random poses at which frames and dynamics are compared.
POSES, DYNAMIC_POSES = 100, 10
#: Bounds: of frames in m; of other differences relative.
MAX_OFFSET, MAX_ERROR = 1e-9, 1e-6
#: Bound of shapes: MuJoCo stores vertices of meshes in single precision.
SHAPE = 1e-5
#: Lever in m: a torque below that of the robot's weight on it is a rounding error.
LEVER = 1e-6
#: Options of MuJoCo that the comparison depends on.
_OPTIONS = ("gravity", "disableflags", "enableflags")
#: Most moving joints of a robot that is compared; above `MAX_JOINTS`, with `OwnDynamics`.
MAX_OWN = 1000


def prove(model: Any, robot: Context, written: Mapping[int, WrittenShape]) -> Proof:
    """Compare a compiled model of MuJoCo with a robot.

    Args:
        model: an ``mujoco.MjModel``; its bodies and joints have the names of the robot's.
        written: the geoms of visuals and collisions, by the ``id`` of the element.

    Raises:
        UrdfkitError: the robot has too many joints, or values that are out of range.
    """
    moving = sum(joint.kind != "fixed" for joint in robot.model.joints)
    if moving > MAX_OWN:
        raise UrdfkitError(
            f"{robot.model.place()}: {moving} joints move; MJCF is verified for up to {MAX_OWN}; "
            "split the robot, or fix some of them"
        )
    is_large = moving > MAX_JOINTS
    poses = _Poses(_without_options(model, robot), robot, is_large=is_large)
    data, placed = poses.at({})
    shape = max(shapes(data, robot, placed, written), default=(0.0, ""))
    inertia = max(inertias(model, robot, poses.reading), default=(0.0, ""))
    frame, mimic, matrix, gravity = poses.compare()
    joint = max((mimic, ""), *joints(model, robot))
    measured = ((frame, MAX_OFFSET), (inertia, MAX_ERROR), (joint, MAX_ERROR), (shape, SHAPE))
    _, worst = max((1.0, ""), *((most / bound, name) for (most, name), bound in measured))
    engine = "urdfkit" if is_large else "Pinocchio"
    reader = "Pinocchio" if poses.reading else "urdfkit"
    of_reader = "" if reader == engine else f", of the URDF as {reader} reads it"
    is_moved = max(inertia[0], matrix, gravity, joint[0]) <= MAX_ERROR
    return Proof(
        frame[0] <= MAX_OFFSET and is_moved and shape[0] <= SHAPE,
        f"MuJoCo and {engine} agree on frames, inertia, mass matrix and gravity torques"
        f"{of_reader}; joints and shapes match the robot",
        f"MuJoCo and {engine} do not agree on the robot: frames {frame[0]:.2g} m, "
        f"inertia {inertia[0]:.2g}, mass matrix {matrix:.2g}, gravity torques {gravity:.2g}, "
        f"joints {joint[0]:.2g}, shapes {shape[0]:.2g}; most at '{worst}'",
        {
            "frames": frame[0],  # of link poses, in m and in entries of the rotation
            # Relative to the largest entry: inertia of links that are fixed together; mass matrix
            # and gravity torques of the whole robot.
            "inertia": inertia[0],
            "mass_matrix": matrix,
            "gravity": gravity,
            "joints": joint[0],  # ranges, efforts, damping, friction and equalities, relative
            "shapes": shape[0],  # pose or size of visuals and collisions, relative to the size
            "part": worst,  # empty if there is no difference
            "engine": engine,  # the program that MuJoCo is compared with
            "reader": reader,  # the parser of the URDF
        },
    )


def _without_options(model: Any, robot: Context) -> Any:
    """A copy of a model without contacts and options of the URDF, such as another gravity."""
    result, expected, plain = copy(model), expected_options(robot), mujoco.MjOption()
    for name in _OPTIONS:
        if np.array_equal(getattr(model.opt, name), getattr(expected, name)):
            setattr(result.opt, name, getattr(plain, name))
    # Contacts do not matter here, and thousands of overlapping shapes exceed MuJoCo's memory.
    result.opt.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT)
    return result


class _Poses:
    """A robot in MuJoCo and in Pinocchio at the same poses.

    Attributes:
        reading: the URDF as Pinocchio reads it; None if it rejects the URDF or runs out of memory.
    """

    def __init__(self, model: Any, robot: Context, *, is_large: bool) -> None:
        self._model, self._robot = model, robot
        self._dynamics = OwnDynamics(robot.tree) if is_large else robot.dynamics
        self.reading = None if is_large else read_text(robot.text)
        self._data = mujoco.MjData(model)
        self._coordinates = _Coordinates(model, robot, self._dynamics)

    def at(self, pose: Mapping[str, float]) -> tuple[Any, dict[str, Floats]]:
        """MuJoCo's data at a pose, and Pinocchio's frames of the links."""
        moved = positions(self._robot.tree, pose)
        self._coordinates.set(self._data, moved)
        mujoco.mj_forward(self._model, self._data)
        reading = self.reading
        placed = reading.placements(moved) if reading else self._dynamics.placements(pose)
        return self._data, placed

    def compare(self) -> tuple[tuple[float, str], float, float, float]:
        """The largest differences at random poses.

        Returns:
            Difference of a frame, with its link; of mimic joints from their leaders; of the mass
            matrix; of the gravity torques.
        """
        frame, mimic, matrix, gravity = (0.0, ""), 0.0, 0.0, 0.0
        dynamics, coordinates = self._dynamics, self._coordinates
        weight = 9.81 * float(self._model.body_mass.sum())
        named = self._robot.model.joints_by_name
        moving = (named[name] for name in dynamics.columns if name in named)
        for number, pose in enumerate(random_poses(moving, POSES)):
            data, placed = self.at(pose)
            frame, mimic = max(frame, _placed(data, placed)), max(mimic, residual(data))
            if number < DYNAMIC_POSES:
                ours = coordinates.compared(dynamics.mass_matrix(pose))
                matrix = max(matrix, relative(ours, coordinates.mass_matrix(data)))
                ours, theirs = (
                    coordinates.compared(dynamics.gravity(pose)),
                    coordinates.gravity(data),
                )
                gravity = max(gravity, relative(ours, theirs, max(ZERO, LEVER * weight)))
        return frame, mimic, matrix, gravity


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

    def set(self, data: Any, moved: Mapping[str, float]) -> None:
        """Set the positions of all joints with one degree of freedom."""
        for name, position in moved.items():
            if name in self._q:
                data.qpos[self._q[name]] = position

    def mass_matrix(self, data: Any) -> Floats:
        """MuJoCo's mass matrix in Pinocchio's coordinates, (n, n)."""
        full_matrix = np.zeros((self._model.nv, self._model.nv))
        mujoco.mj_fullM(self._model, data, full_matrix)
        return np.asarray(self._columns.T @ full_matrix @ self._columns)

    def gravity(self, data: Any) -> Floats:
        """Torque or force that holds each coordinate against gravity, (nv,), in N·m or N."""
        return np.asarray(self._columns.T @ data.qfrc_bias)

    def compared(self, ours: Floats) -> Floats:
        """Pinocchio's values of the compared coordinates; 0 for other coordinates."""
        mask = self._is_compared
        return ours * (np.outer(mask, mask) if ours.ndim == 2 else mask)


def _placed(data: Any, links: Mapping[str, Floats]) -> tuple[float, str]:
    """The largest difference of a link pose, and the name of the link."""
    worst = (0.0, "")
    bodies = names(data.model, "nbody")
    for name, matrix in links.items():
        part = data.body(name) if name in bodies else data.site(name)  # merged link
        frame = homogeneous(part.xmat.reshape(3, 3), part.xpos)
        worst = max(worst, (float(np.abs(frame - matrix).max()), name))
    return worst
