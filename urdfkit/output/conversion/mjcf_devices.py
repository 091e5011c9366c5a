"""Friction and actuators in MJCF."""

from collections.abc import Iterator

import mujoco

from urdfkit.lint.context import Context
from urdfkit.output.conversion.mjcf_inputs import add_given_actuators
from urdfkit.output.conversion.mjcf_robot import MjcfRobot
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_loads import effort
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


def add_frictions(mjcf: MjcfRobot, robot: Context) -> None:
    """Apply Gazebo's friction coefficients; MuJoCo has one for both directions."""
    set_before: dict[str, list[Element]] = {}
    for block in robot.model.gazebo:
        link = block.get("reference") or ""
        written = [child for child in block.children if child.tag in ("mu1", "mu2")]
        values = [number(text_of(child)) for child in written]
        if link not in mjcf.geoms or not values or values[0] is None or values[0] < 0:
            continue
        if not mjcf.geoms[link]:
            for child in written:
                mjcf.losses.lose(child, "the link has no collision")
            continue
        for geom in mjcf.geoms[link]:
            geom.friction[0] = values[0]
        for earlier in set_before.get(link, ()):
            mjcf.losses.lose(earlier, "a later <gazebo> sets the friction")
        set_before[link] = written
        mjcf.losses.keep(block, "body")
        mjcf.losses.keep(written[0], "friction")
        for element, value in zip(written[1:], values[1:], strict=True):
            if value == values[0]:
                mjcf.losses.keep(element, "friction")
            else:
                mjcf.losses.lose(element, "MuJoCo has one coefficient for both directions")


def add_actuators(mjcf: MjcfRobot, robot: Context) -> None:
    """Add an actuator for each joint without ``<mimic>``; a motor if no interface is defined.

    Actuators in ``<mujoco_inputs>`` take precedence.
    """
    driven = add_given_actuators(mjcf, robot)
    commands = dict(_commands(robot))
    for joint in robot.model.joints:
        if joint.mimic or not joint.is_single_dof or joint.name in driven:
            continue
        kind, at = commands.get(joint.name, ("effort", None))
        _actuator(mjcf, joint, kind)
        if at is not None:
            _record(mjcf, at, kind)


def _record(mjcf: MjcfRobot, at: Element, kind: str) -> None:
    """Record the command interface of a joint, and its ancestors."""
    note = f"actuator for {kind}"
    mjcf.losses.keep(at, note)
    for ancestor in (at.parent, at.parent.parent if at.parent else None):
        if ancestor is not None and ancestor.tag in _AROUND:
            mjcf.losses.keep(ancestor, note)
            joint = ancestor.child("joint") if ancestor.tag == "transmission" else None
            mjcf.losses.keep(joint, note)
        elif ancestor is not None and ancestor.tag == "ros2_control":
            mjcf.losses.approximate(ancestor, "actuators for the command interfaces of joints")


def _actuator(mjcf: MjcfRobot, joint: Joint, kind: str) -> None:
    limit = joint.limit
    effort_limit = effort(joint) or 0.0
    actuator = mjcf.spec.add_actuator(
        name=joint.name, target=joint.name, trntype=mujoco.mjtTrn.mjTRN_JOINT
    )
    if kind == "position":
        gain = POSITION_GAIN * (effort_limit or _EFFORT)
        actuator.set_to_position(kp=gain, dampratio=1.0)
        bounds = [bound.value for bound in (limit.lower, limit.upper) if bound] if limit else []
        if len(bounds) == 2 and joint.kind != "continuous":
            actuator.ctrllimited, actuator.ctrlrange = True, bounds
    elif kind == "velocity":
        actuator.set_to_velocity(kv=VELOCITY_GAIN * (effort_limit or _EFFORT))
        if limit and limit.velocity and limit.velocity.value > 0:
            speed = limit.velocity.value
            actuator.ctrllimited, actuator.ctrlrange = True, (-speed, speed)
            mjcf.losses.keep(limit.at.attributes["velocity"], "ctrlrange of the actuator")
    else:
        actuator.set_to_motor()
        if effort_limit:
            actuator.ctrllimited, actuator.ctrlrange = True, (-effort_limit, effort_limit)


def _commands(robot: Context) -> Iterator[tuple[str, tuple[str, Element]]]:
    """Command interface of each joint, and its element; the last definition of a joint applies.

    Of several interfaces, the first applies, or velocity for wheels.
    """
    wheels = {joint.name for joint in robot.model.joints if joint.kind == "continuous"}
    for element, transmission in driven_joints(robot.model.transmissions):
        name = element.get("name") or ""
        interface = element.child("hardwareInterface")
        text = (interface.text if interface else "").lower()
        kind = next((name for name in ("position", "velocity") if name in text), "effort")
        yield name, (kind, interface or transmission)
    for component in components(robot.model):
        for part in component.joints:
            offered = [command for command in part.of("command") if command.name in _KINDS]
            if part.name in wheels:
                offered.sort(key=lambda command: command.name != "velocity")
            for command in offered[:1]:
                yield part.name, (command.name, command.at)
