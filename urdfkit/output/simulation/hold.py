"""Test of joints that are held in position with at most their efforts."""

from collections.abc import Iterator
from typing import Any

import mujoco
import numpy as np

from urdfkit.mesh.geometry import Floats
from urdfkit.output.simulation.simulated_robot import FINE_STEP, SimulatedRobot
from urdfkit.physics.overloads import overloads, worst_pose
from urdfkit.physics.verdicts import Verdict

#: Most deviation of a joint that holds, in rad or m.
SAG = 0.02
#: Seconds that a robot is held for.
DURATION = 1.0
#: Natural frequency of the position control in rad/s, as of a stiff drive.
_STIFFNESS = 30.0
#: The rule about joints whose effort is below their gravity load.
_OVERLOAD = "DYN003"


def hold(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that cannot be held, for a welded robot without contacts.

    Joints are held where they start, in simulation, and against gravity in their worst pose: at the
    start, an arm may be upright, or a slide at its lower end.
    """
    sagging, overloaded = list(_sags(robot)), list(_overloads(robot))
    failing = {name for verdict in sagging for name in verdict.names}
    yield from sagging
    yield from (verdict for verdict in overloaded if failing.isdisjoint(verdict.names))
    if not sagging and not overloaded and np.isfinite(_efforts(robot)).any():
        text = "the efforts of its joints hold it at its start and in their worst poses"
        yield Verdict("hold", True, text, 0.0, SAG)


def _overloads(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint whose effort is below its largest gravity load (DYN003).

    A warning if the effort suffices at the start.
    """
    robot.set_up(contacts=False)
    needed = np.abs(robot.started().qfrc_bias)
    for load in overloads(robot.robot.tree):
        joint = robot.robot.model.joints_by_name[load.joint]
        assert joint.limit is not None
        assert joint.limit.effort is not None
        effort = joint.limit.effort
        force = joint.effort_unit
        text = (
            f"joint '{joint.name}' needs {load.worst:.3g} {force} to hold its load at "
            f"{worst_pose(load)}, its effort is {effort.value:g} {force}"
        )
        warns = bool(needed[robot.dof(joint.name)] <= effort.value)
        names = (joint.name,)
        yield Verdict(
            "hold", warns, text, load.worst, effort.value, names, effort.at, warns, _OVERLOAD
        )


def _sags(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that gives way at the start."""
    robot.set_up(FINE_STEP, contacts=False)
    model, data = robot.model, robot.started()
    needed, start = data.qfrc_bias.copy(), data.qpos.copy()
    most = _efforts(robot)
    for _ in range(round(DURATION / FINE_STEP)):
        data.qfrc_applied = np.clip(torques(model, data, start), -most, most)
        mujoco.mj_step(model, data)
    sags = {}
    for joint in robot.robot.model.joints:
        moves = joint.name in robot.followers or joint in robot.leaders
        if moves and joint.limit and joint.limit.effort:
            at = model.jnt_qposadr[model.joint(joint.name).id]
            sag = abs(float(data.qpos[at] - start[at]))
            if sag > SAG:
                sags[joint] = sag
    # A joint that gives way also moves joints whose efforts suffice.
    is_weak = np.abs(needed) > most
    weak = [joint for joint in sags if is_weak[robot.dof(joint.name)]]
    for joint in weak or sags:
        dof = robot.dof(joint.name)
        force = joint.effort_unit
        text = (
            f"joint '{joint.name}' gives way by {sags[joint]:.2g} {joint.unit} in {DURATION:g} s: "
            f"to hold still it needs {abs(float(needed[dof])):.3g} {force}, its effort is "
            f"{most[dof]:g} {force}"
        )
        names, at = (joint.name,), robot.joint(joint.name)
        yield Verdict("hold", False, text, sags[joint], SAG, names, at, rule=_OVERLOAD)


def torques(model: Any, data: Any, target: Floats) -> Floats:
    """Torques and forces that move a robot to a configuration, critically damped."""
    moved = np.zeros(model.nv)
    mujoco.mj_differentiatePos(model, moved, 1.0, target, data.qpos)
    acceleration = -(_STIFFNESS**2) * moved - 2 * _STIFFNESS * data.qvel
    inertial = np.zeros(model.nv)
    mujoco.mj_mulM(model, data, inertial, acceleration)
    return np.asarray(inertial + data.qfrc_bias)


def _efforts(robot: SimulatedRobot) -> Floats:
    """Effort limit of each coordinate; infinite without a limit."""
    efforts = np.full(robot.model.nv, np.inf)
    for joint in robot.robot.model.joints:
        effort = joint.limit.effort if joint.limit else None
        if effort is not None and (joint.name in robot.followers or joint in robot.leaders):
            efforts[robot.dof(joint.name)] = max(effort.value, 0.0)
    return efforts
