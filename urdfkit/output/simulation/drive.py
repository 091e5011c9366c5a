"""Test of joints that are driven one by one with their full effort."""

from collections.abc import Iterator

import mujoco

from urdfkit.output.simulation.simulated_robot import SimulatedRobot, diverged
from urdfkit.physics.verdicts import Verdict
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import driven, is_passive
from urdfkit.robot.joint_loads import FASTEST, ROTOR, STEP

#: Within this time in s, a joint must reach this velocity in rad/s or m/s, this part of its
#: velocity limit, or an end of its range. Talos' grippers reach half of their limit.
DRIVEN, SPEED, SPEED_PART = 1.0, 0.1, 0.1
#: A joint that moves by less, in rad or m, was at the end of its range.
_MIN_MOVE = 1e-3


def drive(robot: SimulatedRobot) -> Iterator[Verdict]:
    """A verdict for each joint that is too slow or too fast with its effort; without gravity."""
    robot.set_up(gravity=False, contacts=False)
    tested, reported = False, False
    driven_joints = driven(robot.robot.model)
    for joint in robot.leaders:
        limit = joint.limit
        if limit and limit.effort and limit.velocity and limit.velocity.value > 0:
            if limit.effort.value <= 0 and is_passive(joint, driven_joints):
                continue
            tested = True
            verdict = _driven(robot, joint, max(limit.effort.value, 0.0), limit.velocity.value)
            if verdict is not None:
                reported = True
                yield verdict
    if tested and not reported:
        text = "its efforts move its joints, and throw none"
        yield Verdict("drive", True, text, 0.0, SPEED)


def _driven(robot: SimulatedRobot, joint: Joint, effort: float, velocity: float) -> Verdict | None:
    """A verdict on a joint; None if it passes."""
    model, data = robot.model, robot.started()
    dof, start = robot.dof(joint.name), robot.position(data, joint.name)
    lower, upper = robot.range(joint.name) or (-float("inf"), float("inf"))
    sign = 1.0 if upper - start >= start - lower else -1.0
    room = max(upper - start, start - lower) - _MIN_MOVE
    fastest, enough = 0.0, min(SPEED_PART * velocity, SPEED)
    unit, force = joint.unit, joint.effort_unit
    pushed = f"its effort of {effort:g} {force}"
    friction = float(model.dof_frictionloss[dof])
    if effort <= friction:  # in MuJoCo it creeps
        text = f"{pushed} does not overcome its friction of {friction:g} {force}"
        if effort == 0:
            text = f"{pushed} cannot move it"
        warns = effort == friction > 0  # as of Talos' grippers, where both are placeholders
        rule = "JNT041" if friction > 0 else "JNT008"
        return _verdict(joint, text, effort, friction, warns=warns)._replace(rule=rule)
    for number in range(round(DRIVEN / STEP)):
        data.qfrc_applied[dof] = sign * effort
        mujoco.mj_step(model, data)
        speed = abs(float(data.qvel[dof]))
        if diverged(data) is not None:
            text = f"driven by {pushed}, its simulation diverges"
            return _verdict(joint, text, float("inf"), FASTEST)
        if number == 0 and speed > FASTEST * max(velocity, ROTOR):
            text = (
                f"{pushed} takes it to {speed / velocity:.2g} times its velocity of {velocity:g} "
                f"{unit}/s in {STEP * 1e3:g} ms: what it moves has no mass to speak of"
            )
            return _verdict(joint, text, speed / velocity, FASTEST)
        if speed >= enough or abs(robot.position(data, joint.name) - start) >= room:
            return None
        fastest = max(fastest, speed)
    text = (
        f"{pushed} takes it to {fastest:.2g} {unit}/s in {DRIVEN:g} s without gravity, its "
        f"velocity is {velocity:g} {unit}/s"
    )
    verdict = _verdict(joint, text, fastest, enough)
    is_damped = effort <= float(model.dof_damping[dof]) * enough
    return verdict._replace(rule="JNT041") if is_damped else verdict


def _verdict(
    joint: Joint, reason: str, value: float, bound: float, *, warns: bool = False
) -> Verdict:
    text, place = f"joint '{joint.name}': {reason}", joint.limit.at if joint.limit else None
    return Verdict("drive", warns, text, value, bound, (joint.name,), place, warns)
