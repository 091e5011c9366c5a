"""Drop test of a floating robot: whether it lands, sinks, jitters or tips over."""

from collections.abc import Iterator
from math import acos, degrees
from typing import Any

import mujoco
import numpy as np

from urdfkit.output.simulation.simulated_robot import SimulatedRobot, diverged
from urdfkit.physics.verdicts import Verdict
from urdfkit.robot.joint_loads import STEP
from urdfkit.robot.stability import is_freestanding, lowest_links, stand

#: Height of the drop in m, and time in s after which the robot must be still; a robot that falls
#: over late has more time.
HEIGHT, DROPPED, MAX_DURATION = 0.05, 3.0, 6.0
#: Final period in s, and its acceleration bound in m/s²: a robot may roll away.
LAST, JITTER = 0.5, 2.0
#: Most depth in the floor, in m: contacts of MuJoCo yield by 4 mm under a body, and by 11 mm
#: under the light feet of a heavy robot.
DEPTH = 0.02
#: Most tilt, in degrees.
TILT = 30.0


def drop(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict on a floating robot, with its joints locked, that falls on the floor.

    Links collide only with the floor: overlapping links would work against the locks.
    """
    dropped = f"dropped from {HEIGHT * 1e3:g} mm"
    if not robot.model.geom_contype.any():
        text = "no link has a <collision>: it falls through every floor"
        yield Verdict("drop", False, text, 0.0, 0.0)
        return
    robot.set_up()
    conaffinity = robot.model.geom_conaffinity.copy()
    robot.model.geom_conaffinity[robot.model.geom_type != mujoco.mjtGeom.mjGEOM_PLANE] = 0
    try:
        yield _dropped(robot, dropped)
    finally:
        robot.model.geom_conaffinity[:] = conaffinity


def _dropped(robot: SimulatedRobot, dropped: str) -> Verdict:
    data = robot.started()
    _lock(robot, data)
    data.qpos[2] += HEIGHT
    jitter, calm, before = 0.0, 0, data.qvel[:3].copy()
    for number in range(round(MAX_DURATION / STEP)):
        mujoco.mj_step(robot.model, data)
        if diverged(data) is not None:
            text = f"{dropped}, the robot diverges after {number * STEP:.2g} s"
            return Verdict("drop", False, text, float("inf"), JITTER)
        jitter = float(np.abs(data.qvel[:3] - before).max()) / STEP
        before = data.qvel[:3].copy()
        calm = calm + 1 if jitter <= JITTER else 0
        if number * STEP >= DROPPED and calm * STEP >= LAST:
            break
    is_calm = calm * STEP >= LAST
    in_floor = (
        (depth, max(pair, key="world".__ne__))
        for pair, depth in robot.contacts(data)
        if "world" in pair
    )
    depth, link = max(in_floor, default=(0.0, ""))
    tilt = degrees(acos(max(-1.0, min(1.0, float(data.body(1).xmat[8])))))
    if depth > DEPTH:
        text = f"{dropped}, link '{link}' sinks into the floor by {depth * 1e3:.3g} mm"
        return Verdict("drop", False, text, depth, DEPTH, (link,), robot.collision(link))
    if not is_calm:
        text = (
            f"{dropped}, the robot still jitters after {MAX_DURATION:g} s, with {jitter:.2g} m/s²"
        )
        return Verdict("drop", False, text, jitter, JITTER, rule=_tips_over(robot))
    if tilt > TILT and _is_to_stand(robot):
        text = f"{dropped}, the robot tips over by {tilt:.0f} degrees"
        return Verdict("drop", False, text, tilt, TILT, rule=_tips_over(robot))
    fallen = f", tilted by {tilt:.0f} degrees" if tilt > TILT else ""
    text = f"{dropped}, the robot lies on the floor after {DROPPED:g} s{fallen}"
    return Verdict("drop", True, text, jitter, JITTER)


def _lock(robot: SimulatedRobot, data: Any) -> None:
    """Keep all joints where they are."""
    model = robot.model
    for number in range(model.neq):
        if model.eq_type[number] == mujoco.mjtEq.mjEQ_JOINT and model.eq_obj2id[number] < 0:
            at = model.jnt_qposadr[model.eq_obj1id[number]]
            model.eq_data[number, 0] = data.qpos[at] - model.qpos0[at]
            data.eq_active[number] = 1


def _tips_over(robot: SimulatedRobot) -> str:
    """The rule that finds that the robot tips over where it stands; empty if it does not."""
    standing = stand(robot.robot) if _is_to_stand(robot) else None
    return "DYN004" if standing and standing.tips else ""


def _is_to_stand(robot: SimulatedRobot) -> bool:
    """True for a robot on wheels and casters; False if it balances on two wheels."""
    links, tree = lowest_links(robot.robot), robot.robot.tree
    has_wheel = any(joint.kind == "continuous" for link in links for joint in tree.path(link))
    return len(links) > 2 and has_wheel and is_freestanding(tree, links)
