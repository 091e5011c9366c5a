"""Friction and actuators in MJCF."""

from collections.abc import Iterator

import mujoco

from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.robot.joint_loads import effort
from urdfkit.robot.model import Joint
from urdfkit.robot.values import number
from urdfkit.ros.gazebo.values import text_of
from urdfkit.ros.ros_control import components, driven_joints
from urdfkit.text.document import Element

#: Gains of actuators for positions, in N·m/rad or N/m, and for velocities, for each N·m or N of
#: effort: an error of 0.1 rad, or of 1 rad/s, commands the full effort.
POSITION_GAIN, VELOCITY_GAIN = 10.0, 1.0
#: Interfaces for which an actuator exists.
_KINDS = ("position", "velocity", "effort")
#: Ancestors of an interface that are kept with it.
_AROUND = ("joint", "transmission", "actuator")
#: Effort for the gains of a joint without a limit, in N·m or N.
_EFFORT = 100.0


def add_frictions(made: MjcfRobot, robot: Context) -> None:
    """Apply Gazebo's friction coefficients; MuJoCo has one for both directions."""
    set_before: dict[str, list[Element]] = {}
    for block in robot.model.gazebo:
        link = block.get("reference") or ""
        written = [one for one in block.children if one.tag in ("mu1", "mu2")]
        values = [number(text_of(one)) for one in written]
        if link not in made.geoms or not values or values[0] is None or values[0] < 0:
            continue
        if not made.geoms[link]:
            for one in written:
                made.losses.lose(one, "the link has no collision")
            continue
        for geom in made.geoms[link]:
            geom.friction[0] = values[0]
        for earlier in set_before.get(link, ()):
            made.losses.lose(earlier, "a later <gazebo> sets the friction")
        set_before[link] = written
        made.losses.keep(block, "body")
        made.losses.keep(written[0], "friction")
        for other, value in zip(written[1:], values[1:], strict=True):
            if value == values[0]:
                made.losses.keep(other, "friction")
            else:
                made.losses.lose(other, "MuJoCo has one coefficient for both directions")


def add_actuators(made: MjcfRobot, robot: Context) -> None:
    """Add an actuator for each joint without ``<mimic>``; a motor if no interface is defined."""
    commands = dict(_commands(robot))
    for joint in robot.model.joints:
        if joint.mimic or joint.kind not in ("revolute", "continuous", "prismatic"):
            continue
        kind, at = commands.get(joint.name, ("effort", None))
        _actuator(made, joint, kind)
        if at is not None:
            _record(made, at, kind)


def _record(made: MjcfRobot, at: Element, kind: str) -> None:
    """Record the command interface of a joint, and its ancestors."""
    what = f"actuator for {kind}"
    made.losses.keep(at, what)
    for above in (at.parent, at.parent.parent if at.parent else None):
        if above is not None and above.tag in _AROUND:
            made.losses.keep(above, what)
            made.losses.keep(above.child("joint") if above.tag == "transmission" else None, what)
        elif above is not None and above.tag == "ros2_control":
            made.losses.approximate(above, "actuators for the interfaces that command joints")


def _actuator(made: MjcfRobot, joint: Joint, kind: str) -> None:
    limit = joint.limit
    most = effort(joint) or 0.0
    actuator = made.spec.add_actuator(
        name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
    )
    if kind == "position":
        gain = POSITION_GAIN * (most or _EFFORT)
        actuator.set_to_position(kp=gain, dampratio=1.0)
        ends = [one.value for one in (limit.lower, limit.upper) if one] if limit else []
        if len(ends) == 2 and joint.kind != "continuous":
            actuator.ctrllimited, actuator.ctrlrange = True, ends
    elif kind == "velocity":
        actuator.set_to_velocity(kv=VELOCITY_GAIN * (most or _EFFORT))
        if limit and limit.velocity and limit.velocity.value > 0:
            speed = limit.velocity.value
            actuator.ctrllimited, actuator.ctrlrange = True, (-speed, speed)
            made.losses.keep(limit.at.attributes["velocity"], "ctrlrange of the actuator")
    else:
        actuator.set_to_motor()
        if most:
            actuator.ctrllimited, actuator.ctrlrange = True, (-most, most)


def _commands(robot: Context) -> Iterator[tuple[str, tuple[str, Element]]]:
    """Command interface of each joint, and its element; the last one counts.

    Of several interfaces the first counts, except for wheels: velocity.
    """
    wheels = {joint.name for joint in robot.model.joints if joint.kind == "continuous"}
    for element, transmission in driven_joints(robot.model.transmissions):
        name = element.get("name") or ""
        interface = element.child("hardwareInterface")
        text = (interface.text if interface else "").lower()
        kind = next((one for one in ("position", "velocity") if one in text), "effort")
        yield name, (kind, interface or transmission)
    for component in components(robot.model):
        for part in component.joints:
            offered = [one for one in part.of("command") if one.name in _KINDS]
            if part.name in wheels:
                offered.sort(key=lambda one: one.name != "velocity")
            for one in offered[:1]:
                yield part.name, (one.name, one.at)
