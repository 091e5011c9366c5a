"""Tests of joints over their ranges: self-collisions, and positions of mimic joints."""

from collections.abc import Iterator, Mapping, Sequence
from math import inf, pi
from random import Random
from typing import Any

import mujoco
import numpy as np

from urdfkit.output.simulation.hold import SAG, torques
from urdfkit.output.simulation.simulated_robot import OVERLAP, SimulatedRobot
from urdfkit.physics.verdicts import Verdict
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import overshoot, span
from urdfkit.robot.joint_loads import STEP
from urdfkit.robot.kinematics import MimicLaw, laws, positions

#: Number of positions of a joint that are tested in its range.
SAMPLES = 24
#: A joint is jammed if links collide when it moves to either side by this part of its range, or
#: by this much in rad or m, whichever is less.
RANGE_PART, TURN, SLIDE = 0.1, 0.1, 0.02
#: Number of random poses of the other joints in which a jammed joint is tried.
TRIALS = 20
#: Time in s for which leaders are held at an end of their ranges.
_HELD = 0.5


def sweep(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that is jammed by self-collisions.

    Other joints stay at their start, and move only to free a joint that is jammed there. Links
    with a joint between them are ignored, as are pairs that overlap at the start.
    """
    robot.set_up()
    poses = _Poses(robot)
    least, jams = (1.0, ""), False
    for joint in robot.leaders:
        start = poses.start[joint.name]
        lower, upper = robot.range(joint.name) or (start - pi, start + pi)
        least = min(least, (_free_part(poses, joint.name, lower, upper), joint.name))
        step = min(RANGE_PART * (upper - lower), SLIDE if joint.is_prismatic else TURN)
        near = [at for at in (start - step, start + step) if lower <= at <= upper]
        hits = [(at, poses.collision(joint.name, at)) for at in near]
        jam = next(((at, *hit) for at, hit in hits if hit), None)
        if jam and all(hit for _, hit in hits) and poses.is_jammed(joint.name, near):
            jams = True
            at, names, depth = jam
            links = " and ".join(f"'{name}'" for name in names)
            text = (
                f"joint '{joint.name}' is jammed: at {at:.3g} {joint.unit} {links} overlap "
                f"by {depth * 1e3:.3g} mm"
            )
            yield Verdict("sweep", False, text, depth, OVERLAP, names, robot.collision(names[0]))
    if robot.leaders and not jams:
        text = "no links collide while a joint moves"
        if least[0] < 1:
            text = f"no joint is jammed; '{least[1]}' is free in {least[0]:.0%} of its range"
        yield Verdict("sweep", True, text, 0.0, OVERLAP)


class _Poses:
    """Collisions of a robot in poses."""

    def __init__(self, robot: SimulatedRobot) -> None:
        self._robot = robot
        self._data = robot.started()
        self._before = robot.overlaps(self._data)
        self.start = _given(robot, self._data)

    def collision(self, joint: str, position: float) -> tuple[tuple[str, str], float] | None:
        """The deepest pair of links with one joint moved, and the depth in m."""
        overlaps = self._overlaps({**self.start, joint: position})
        return max(overlaps.items(), key=lambda item: item[1], default=None)

    def _overlaps(self, pose: Mapping[str, float]) -> dict[tuple[str, str], float]:
        """Depth in m of pairs of links that overlap in a pose, and not at the start."""
        model, data = self._robot.model, self._data
        self._robot.place(data, pose)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_collision(model, data)
        return {
            pair: depth
            for pair, depth in self._robot.overlaps(data).items()
            if frozenset(pair) not in self._robot.neighbours and pair not in self._before
        }

    def is_jammed(self, joint: str, near: Sequence[float]) -> bool:
        """True if the same pairs of links block a joint in random poses of the other joints, too.

        Hands that hang next to the thighs block a torso, which the arms can free.
        """
        random, start = Random(0), self.start[joint]
        model = self._robot.robot.model.joints_by_name
        blocking = {pair for at in near for pair in self._overlaps({**self.start, joint: at})}
        for _ in range(TRIALS):
            pose = {name: random.uniform(*span(model[name])) for name in self.start}
            free = (blocking.isdisjoint(self._overlaps({**pose, joint: at})) for at in near)
            if blocking.isdisjoint(self._overlaps({**pose, joint: start})) and any(free):
                return False
        return True


def _free_part(poses: _Poses, joint: str, lower: float, upper: float) -> float:
    """The part of a range, around the start, without collisions."""
    grid = np.linspace(lower, upper, SAMPLES + 1)
    first = int(np.abs(grid - poses.start[joint]).argmin())
    free = 0
    for side in (grid[first + 1 :], grid[:first][::-1]):
        for at in side:
            if poses.collision(joint, float(at)):
                break
            free += 1
    return free / SAMPLES


def _given(robot: SimulatedRobot, data: Any) -> dict[str, float]:
    return {joint.name: robot.position(data, joint.name) for joint in robot.leaders}


def follow(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each mimic joint that its leader drives beyond its range, or that lags."""
    if not robot.followers:
        return
    stopped = list(_stopped(robot))
    failing = {name for verdict in stopped for name in verdict.names}
    worst = dict.fromkeys(robot.followers, (0.0, 0.0, 0.0))
    for end in (0, 1):
        for name, (is_at, should) in _held_at(robot, end).items():
            worst[name] = max(worst[name], (abs(is_at - should), is_at, should))
    lagging = [
        _lag(robot, name, *deviation)
        for name, deviation in worst.items()
        if deviation[0] > SAG and name not in failing
    ]
    yield from (*stopped, *lagging)
    if not stopped and not lagging:
        most = max(deviation for deviation, _, _ in worst.values())
        text = f"mimic joints deviate from their leaders by at most {most:.2g} rad or m"
        yield Verdict("mimic", True, text, most, SAG)


def _stopped(robot: SimulatedRobot) -> Iterator[Verdict]:
    """Verdicts on mimic joints whose own range ends before that of their leader (JNT016)."""
    joints = robot.robot.model.joints_by_name
    couplings, leaders = laws(joints), {joint.name for joint in robot.leaders}
    for name, leader in robot.followers.items():
        leading = robot.range(leader) if leader in leaders else None  # JNT015
        own = robot.range(name)
        if leading is None or own is None:
            continue
        law = couplings[name]
        low, high = sorted(law.factor * end + law.shift for end in leading)
        beyond = overshoot((low, high), own)
        if beyond > 0:
            joint = joints[name]
            text = (
                f"joint '{name}': its <mimic> of '{leader}' drives it through [{low:.3g}, "
                f"{high:.3g}] {joint.unit}, its own range is [{own[0]:.3g}, {own[1]:.3g}]: "
                f"{_blocked(joints[leader], law, leading, own)}"
            )
            at = joint.mimic.at if joint.mimic else None
            yield Verdict("mimic", False, text, beyond, 0.0, (name,), at, rule="JNT016")


def _blocked(
    leader: Joint, law: MimicLaw, leading: tuple[float, float], own: tuple[float, float]
) -> str:
    """The part of its range in which a leader can move."""
    ends = [(end - law.shift) / law.factor for end in own] if law.factor else [inf, inf]
    low, high = max(leading[0], min(ends)), min(leading[1], max(ends))
    if low > high:
        return f"no position of '{leader.name}' is within it"
    if low == high:
        return f"'{leader.name}' cannot move"
    return f"'{leader.name}' can only move from {low:.3g} to {high:.3g} {leader.unit}"


def _lag(
    robot: SimulatedRobot, name: str, deviation: float, is_at: float, should: float
) -> Verdict:
    joint = robot.robot.model.joints_by_name[name]
    text = (
        f"joint '{name}' does not follow '{robot.followers[name]}': it is at {is_at:.3g} "
        f"{joint.unit} where <mimic> takes it to {should:.3g} {joint.unit}"
    )
    place = joint.mimic.at if joint.mimic else None
    return Verdict("mimic", False, text, deviation, SAG, (name,), place)


def _held_at(robot: SimulatedRobot, end: int) -> dict[str, tuple[float, float]]:
    """Actual and expected positions of mimic joints, with all leaders held at an end."""
    robot.set_up(gravity=False, contacts=False)
    model, data = robot.model, robot.started()
    driven = np.zeros(model.nv)
    at = _given(robot, data)
    for name in at:
        driven[robot.dof(name)] = 1.0
        at[name] = (robot.range(name) or (at[name], at[name]))[end]
    robot.place(data, at)
    target = data.qpos.copy()
    for _ in range(round(_HELD / STEP)):
        data.qfrc_applied = torques(model, data, target) * driven
        mujoco.mj_step(model, data)
    should = positions(robot.robot.tree, _given(robot, data))
    return {name: (robot.position(data, name), should[name]) for name in robot.followers}
