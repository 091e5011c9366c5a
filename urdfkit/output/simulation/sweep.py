"""Joints through their ranges: what collides on the way, and whether what follows does."""

from collections.abc import Iterator
from math import cos, pi
from typing import Any

import mujoco
import numpy as np

from urdfkit.output.simulation.hold import SAG, torques
from urdfkit.output.simulation.simulated_robot import STEP, SimulatedRobot, unit_of
from urdfkit.output.simulation.verdicts import Verdict
from urdfkit.robot.kinematics import positions
from urdfkit.robot.model import Joint

#: Positions of a joint that are looked at between its ends.
SAMPLES = 24
#: A joint that moves less from its start before links collide, as a part of its range, is jammed.
FREE = 0.1
#: Seconds from one end to the other and back.
_SWEPT = 2.0


def sweep(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that collisions of the robot with itself jam.

    The other joints stay at their start. Links with a joint between them do not count, nor what
    overlaps at the start.
    """
    robot.set_up()
    data = robot.started()
    before, start = robot.overlaps(data), _given(robot, data)
    least, fails = (1.0, ""), False
    for joint in robot.leaders:
        lower, upper = robot.range(joint.name) or (start[joint.name] - pi, start[joint.name] + pi)
        grid = np.linspace(lower, upper, SAMPLES + 1)
        first = int(np.abs(grid - start[joint.name]).argmin())
        free, (names, at, depth) = _free(robot, data, {**start}, joint.name, grid, first, before)
        least = min(least, (free, joint.name))
        if free < FREE:
            fails = True
            unit, _ = unit_of(joint)
            links = " and ".join(f"'{name}'" for name in names)
            text = (
                f"joint '{joint.name}' is free in {free:.0%} of its range, {lower:.3g} to "
                f"{upper:.3g} {unit}: at {at:.3g} {unit} {links} overlap by {depth * 1e3:.3g} mm"
            )
            yield Verdict("sweep", False, text, free, FREE, names, robot.collision(names[0]))
    if robot.leaders and not fails:
        text = "no links collide while a joint moves"
        if least[0] < 1:
            text = (
                f"each joint moves without a collision: '{least[1]}' in {least[0]:.0%} of its range"
            )
        yield Verdict("sweep", True, text, least[0], FREE)


def _given(robot: SimulatedRobot, data: Any) -> dict[str, float]:
    return {joint.name: robot.position(data, joint.name) for joint in robot.leaders}


def _free(
    robot: SimulatedRobot,
    data: Any,
    given: dict[str, float],
    joint: str,
    grid: Any,
    first: int,
    before: dict[tuple[str, str], float],
) -> tuple[float, tuple[tuple[str, ...], float, float]]:
    """The part of a range around the start without collisions; and the collision next to it."""
    free, hits = 0, []
    for numbers in (range(first + 1, len(grid)), range(first - 1, -1, -1)):
        for number in numbers:
            given[joint] = float(grid[number])
            robot.place(data, given)
            mujoco.mj_kinematics(robot.model, data)
            mujoco.mj_comPos(robot.model, data)
            mujoco.mj_collision(robot.model, data)
            new = {
                pair: depth
                for pair, depth in robot.overlaps(data).items()
                if frozenset(pair) not in robot.neighbours and pair not in before
            }
            if new:
                names = max(new, key=lambda pair: new[pair])
                hits.append((abs(number - first), names, given[joint], new[names]))
                break
            free += 1
    nearest = min(hits, default=(0, (), 0.0, 0.0))
    return free / (len(grid) - 1), nearest[1:]


def follow(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that does not follow its leader from end to end and back."""
    if not robot.followers:
        return
    robot.set_up(contacts=False)
    model, data = robot.model, robot.started()
    start, driven = _given(robot, data), np.zeros(model.nv)
    ends = {name: robot.range(name) or (start[name] - pi, start[name] + pi) for name in start}
    for name in start:
        driven[robot.dof(name)] = 1.0
    robot.place(data, {name: lower for name, (lower, _) in ends.items()})
    worst = dict.fromkeys(robot.followers, (0.0, 0.0, 0.0))
    wanted = data.qpos.copy()
    for number in range(round(_SWEPT / STEP)):
        part = (1 - cos(2 * pi * number * STEP / _SWEPT)) / 2
        at = {name: lower + part * (upper - lower) for name, (lower, upper) in ends.items()}
        for name in start:
            wanted[model.jnt_qposadr[model.joint(name).id]] = at[name]
        data.qfrc_applied = torques(model, data, wanted) * driven
        mujoco.mj_step(model, data)
        real = positions(robot.robot.tree, _given(robot, data))
        for name in robot.followers:
            is_at = robot.position(data, name)
            worst[name] = max(worst[name], (abs(is_at - real[name]), is_at, real[name]))
    fails = False
    for name, (apart, is_at, should) in worst.items():
        if apart > SAG:
            fails = True
            joint: Joint = robot.robot.model.joints_by_name[name]
            unit, _ = unit_of(joint)
            text = (
                f"joint '{name}' does not follow '{robot.followers[name]}': it is at {is_at:.3g} "
                f"{unit} where <mimic> takes it to {should:.3g} {unit}"
            )
            place = joint.mimic.at.span if joint.mimic else None
            yield Verdict("mimic", False, text, apart, SAG, (name,), place)
    if not fails:
        most = max(apart for apart, _, _ in worst.values())
        text = f"what follows a joint is never off by more than {most:.2g} rad or m"
        yield Verdict("mimic", True, text, most, SAG)
