"""Test of a robot without drives: it may fall, but must not diverge or gain energy."""

from __future__ import annotations

from collections.abc import Iterator

import mujoco

from urdfkit.core.record import Record
from urdfkit.core.spatial import Transform
from urdfkit.output.simulation.overlap import OVERLAPPING
from urdfkit.output.simulation.simulated_robot import FINE_STEP, SimulatedRobot, diverged
from urdfkit.output.simulation.timestep import light_link
from urdfkit.physics.verdicts import Verdict
from urdfkit.robot.joint_loads import STEP
from urdfkit.robot.values import number
from urdfkit.text.document import Element

#: Bound of energy gain: the energy to lift the robot by this height in m, plus this part of its
#: largest kinetic energy.
LIFT, KINETIC_PART = 1e-3, 0.01
#: Part of the kinetic energy that a valid robot, such as a UR10e, may gain from the default step.
PART_OF_STEPS = 0.1
#: Overlapping links throw a robot if the energy that they add lifts it by more than this
#: part of its size: HyQ is lifted by 0.03 of it, an SO-100 by 0.7, an SO-101 by 70.
THROWN = 0.3
#: Duration in s.
DURATION = 2.0


class _Release(Record):
    """Energies of a released robot."""

    gain: float  # largest energy above the initial energy, in J
    weight: float  # in N
    kinetic: float  # largest kinetic energy, in J
    bad: int | None  # index of the coordinate that diverges; None if none does

    @property
    def bound(self) -> float:
        return LIFT * self.weight + KINETIC_PART * self.kinetic

    @property
    def is_calm(self) -> bool:
        return self.bad is None and self.gain <= self.bound

    @property
    def may_be_of_steps(self) -> bool:
        """True if the gain is so small that it may be an error of integration."""
        return self.bad is None and self.gain <= PART_OF_STEPS * self.kinetic


def release(robot: SimulatedRobot) -> Iterator[Verdict]:
    """Verdicts on whether a robot gains energy or diverges, with the cause."""
    yield from _driven_by_damping(robot)
    result = _released(robot, STEP)
    text = (
        f"released for {DURATION:g} s, the robot gains {result.gain:.2g} J "
        f"(bound {result.bound:.2g} J)"
    )
    if result.is_calm:
        yield Verdict("energy", True, text, result.gain, result.bound)
        return
    if result.may_be_of_steps and _released(robot, FINE_STEP).is_calm:
        text += f", but not with steps of {FINE_STEP * 1e3:g} ms instead of {STEP * 1e3:g}"
        yield Verdict("energy", True, text, result.gain, result.bound)
        return
    why, names, at = _cause(robot)
    if result.bad is None:
        thrown = THROWN * robot.extent() * result.weight
        is_of_overlap = len(names) == 2
        warns = is_of_overlap and result.gain <= thrown
        rule = OVERLAPPING if warns else ""
        yield Verdict(
            "energy", warns, text + why, result.gain, result.bound, names, at, warns, rule
        )
        return
    model = robot.model
    joint = model.joint(model.dof_jntid[result.bad]).name if result.bad < model.nv else ""
    text = f"released, the robot diverges at joint '{joint}'{why}"
    place = at or robot.joint(joint)
    yield Verdict("stability", False, text, result.gain, result.bound, names or (joint,), place)


def _driven_by_damping(robot: SimulatedRobot) -> Iterator[Verdict]:
    """Verdicts on joints with negative damping, which MuJoCo does not support."""
    for joint in robot.leaders:
        dynamics = joint.at.child("dynamics")
        written = dynamics.attributes.get("damping") if dynamics else None
        damping = number(written.value) if written else None
        if written and damping is not None and damping < 0:
            text = (
                f"joint '{joint.name}' is driven by its damping of {damping:g} "
                f"{joint.effort_unit}·s/{joint.unit}"
            )
            names = (joint.name,)
            yield Verdict("energy", False, text, damping, 0.0, names, written, rule="JNT008")


def _cause(robot: SimulatedRobot) -> tuple[str, tuple[str, ...], Element | None]:
    """Why a robot gains energy, and the links or joints that cause it."""
    is_of_contacts = _released(robot, STEP, contacts=False).is_calm
    robot.set_up()
    overlaps = robot.overlaps(robot.started())
    if is_of_contacts and overlaps:
        first, second = max(overlaps, key=lambda pair: overlaps[pair])
        text = f", but not without contacts: '{first}' and '{second}' push each other away"
        return text, (first, second), robot.collision(first)
    if _released(robot, FINE_STEP).is_calm:
        return f", but not with steps of {FINE_STEP * 1e3:g} ms", (), None
    if is_of_contacts:
        return ", but not without contacts", (), None
    text, names, at = light_link(robot)
    half = _released(robot, STEP / 2)
    result = f"gains {half.gain:.2g} J" if half.bad is None else "diverges, too"
    return f", and with steps of {STEP / 2 * 1e3:g} ms it {result}{text}", names, at


def _released(robot: SimulatedRobot, step: float, *, contacts: bool = True) -> _Release:
    robot.set_up(step, contacts=contacts)
    model, data = robot.model, robot.started()
    start = most = float(data.energy.sum())
    kinetic, bad = 0.0, None
    for _ in range(round(DURATION / step)):
        mujoco.mj_step(model, data)
        most = max(most, float(data.energy.sum()))
        kinetic = max(kinetic, float(data.energy[1]))
        bad = diverged(data)
        if bad is not None:
            break
    return _Release(most - start, robot.weight, kinetic, bad)


def moments(robot: SimulatedRobot, images: int) -> Iterator[dict[str, Transform]]:
    """Link poses in the world of a released robot, at equal intervals.

    Ends early if the simulation diverges.
    """
    robot.set_up()
    data, steps = robot.started(), round(DURATION / STEP)
    for step in range(steps + 1):
        if step % (steps // (images - 1)) == 0:
            yield robot.frames(data)
        mujoco.mj_step(robot.model, data)
        if diverged(data) is not None:
            return
