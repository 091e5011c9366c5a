"""Test of the energy error of a robot when the time step is halved."""

from collections.abc import Iterator
from math import inf

import mujoco

from urdfkit.output.simulation.simulated_robot import SimulatedRobot, diverged
from urdfkit.physics.verdicts import Verdict
from urdfkit.robot.joint_loads import LIGHT, STEP, light_joints
from urdfkit.text.document import Element

#: Largest energy error. With steps of 2 ms a UR5 has 0.01, an SO-100 0.28, a Panda 0.38.
MAX_ERROR = 1.0
#: Duration in s.
DURATION = 1.0
#: A robot that moves less has no error: the energy to lift it by this height in m.
_MIN_LIFT = 1e-3


def timestep(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A warning if the energy depends on the step; without contacts, damping, friction and limits.

    The energy is then constant; its largest change, as a part of the largest kinetic energy, is the
    error of integration.
    """
    error, half = _error(robot, STEP), _error(robot, STEP / 2)
    text = (
        f"energy error {_percent(error)} with steps of {STEP * 1e3:g} ms, {_percent(half)} with "
        f"{STEP * 5e2:g} ms"
    )
    if error <= MAX_ERROR:
        yield Verdict("timestep", True, text, error, MAX_ERROR)
        return
    cause, names, at = light_link(robot)
    text += cause or f" (bound {MAX_ERROR * 100:g} %): simulate it with shorter steps"
    rule = "DYN005" if names else ""
    yield Verdict("timestep", True, text, error, MAX_ERROR, names, at, True, rule)


def _percent(error: float) -> str:
    return "without bound" if error == inf else f"{error * 100:.2g} %"


def light_link(robot: SimulatedRobot) -> tuple[str, tuple[str, ...], Element | None]:
    """The first link that is too light for what it carries (DYN005), as a cause of an error."""
    for joint in light_joints(robot.robot.tree):
        link = robot.robot.model.links_by_name[joint.child_name]
        place = link.inertial.at if link.inertial else link.at
        text = f": link '{link.name}' has less than {LIGHT:g} of the mass that it carries"
        return text, (link.name,), place
    return "", (), None


def _error(robot: SimulatedRobot, step: float) -> float:
    robot.set_up(step, contacts=False)
    model = robot.model
    for flag in ("LIMIT", "FRICTIONLOSS", "DAMPER"):
        model.opt.disableflags |= int(getattr(mujoco.mjtDisableBit, f"mjDSBL_{flag}"))
    data = robot.started()
    start, error, kinetic = float(data.energy.sum()), 0.0, 0.0
    for _ in range(round(DURATION / step)):
        mujoco.mj_step(model, data)
        if diverged(data) is not None:
            return inf
        error = max(error, abs(float(data.energy.sum()) - start))
        kinetic = max(kinetic, float(data.energy[1]))
    return error / kinetic if kinetic > _MIN_LIFT * robot.weight else 0.0
