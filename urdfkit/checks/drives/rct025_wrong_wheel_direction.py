"""Wheels or rotors turn in the wrong direction: sides are swapped, or axes are opposite.

Drive plugins and controllers command the same speed for all wheels of a side, positive for
forwards. The axis of the wheels defines the direction in which the robot rolls, and so the left
side.

- Left and right are swapped: the robot, and its odometry, turn to the wrong side.
- The axes of a left and a right wheel are opposite: the robot spins instead of driving straight.
- The axes are vertical, so that the wheels lie flat: an rpy in the `<origin>` of a joint also
  rotates its `<axis>`.
- The joints of a steering controller of ros2_controllers are swapped; the first joint of a list is
  the right one. The inner wheel gets the speed or the angle of the outer wheel, and skids. Or the
  axes of the steering joints point down: the robot steers the wrong way.
- One of four wheels has a reversed `<axis>`: the robot skids, turns or stands still, while its
  odometry does not show it. Robots whose left wheels all turn opposite to the right wheels are not
  reported.
- One of four rotors turns otherwise than the opposite one: the torques do not cancel, and the drone
  yaws.
- The axes of the only left and right wheel are opposite and no drive is known (info): the driver of
  some robots inverts one sign.

Sources:
    diff_drive_controller: https://control.ros.org/master/doc/ros2_controllers/diff_drive_controller/doc/userdoc.html
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    ackermann_steering_controller.hpp, order of the joints: https://github.com/ros-controls/ros2_controllers/blob/master/ackermann_steering_controller/include/ackermann_steering_controller/ackermann_steering_controller.hpp
    ros-controls/gz_ros2_control#438: https://github.com/ros-controls/gz_ros2_control/issues/438
    REP 103, units and axes: https://www.ros.org/reps/rep-0103.html
    AutonomyLab/create_robot#77: https://github.com/AutonomyLab/create_robot/issues/77
    vislab-tecnico-lisboa/vizzy#68: https://github.com/vislab-tecnico-lisboa/vizzy/issues/68
    measured: of 671 public robots six have an opposite pair, of 1300 none has one of four
"""

from __future__ import annotations

from itertools import product
from math import dist

from urdfkit.core.grouping import by_key
from urdfkit.core.spatial import Vector, dot, rotate
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.lint.context import Context
from urdfkit.lint.rules import Confidence, Finding, Findings, Need, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.kinematics import direction
from urdfkit.ros.gazebo.drives import (
    Wheel,
    drive_of,
    pairs,
    wheel_of,
    wheels,
    wrong_direction,
    wrong_steering,
)
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import DRIVE, DRIVEN
from urdfkit.text.diagnostic import Related
from urdfkit.text.document import Element

if TYPE_CHECKING:
    from collections.abc import Iterator

    from urdfkit.ros.controllers import Controller
    from urdfkit.text.located_yaml import Value

BAD = DRIVEN
GOOD = BAD.replace("bad.yaml", "good.yaml")
FILES = {
    "config/bad.yaml": DRIVE.replace(b"left_joint", b"?")
    .replace(b"right_joint", b"left_joint")
    .replace(b"?", b"right_joint"),
    "config/good.yaml": DRIVE,
}

_LEFT = ("left_wheel_names", "left_wheel")
_RIGHT = ("right_wheel_names", "right_wheel")
#: The lists of the steering controllers.
_AXLES = (
    "traction_joints_names", "steering_joints_names", "rear_wheels_names", "front_wheels_names",
)  # fmt: skip

#: The effect of a swapped pair of wheels.
_SKIDS = "the inner wheel gets the speed of the outer one"

#: Words in names of joints other than those of drive wheels.
_OTHERS = ("caster", "castor", "swivel", "steer", "mecanum", "omni", "roller")

#: Least cosine of the angle of two parallel axles.
_PARALLEL = 0.95


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    yield from _rotors(context)
    for explain in (_one_of_four, _wrong_drives, _opposite):  # the most precise explanation first
        if findings := list(explain(context)):
            yield from findings
            return


def _rotors(context: Context) -> Findings:
    """The rotor of a quadrotor that turns otherwise than the opposite one."""
    rotors = [
        (joint, item)
        for use in context.plugins
        for item in use.values("turningDirection")[:1]
        if (joint := context.model.joints_by_name.get(use.value("jointName")))
    ]
    axes = [_axle(context, joint) or (0, 0, 0) for joint, _ in rotors]
    if len(axes) != 4 or any(dot(axes[0], axis) < _PARALLEL for axis in axes):
        return
    directions = by_key((item.text, (joint, item)) for joint, item in rotors).values()
    single, *rest = sorted(directions, key=len)
    if len(single) != 1 or len(rest) != 1:
        return
    others = rest[0]
    joint, turning = single[0]
    places = {each.name: context.tree.frames[each.child_name].position for each, _ in rotors}
    wrong, item = max(others, key=lambda other: dist(places[joint.name], places[other[0].name]))
    yield Finding(
        item.at,
        f"rotor '{wrong.child_name}' turns {item.text}, as two of the others do, but the opposite "
        f"rotor '{joint.child_name}' {turning.text}",
        f"write {turning.text}, so that opposite rotors turn alike",
        related=(Related(turning.at.span, f"rotor '{joint.child_name}'"),),
        confidence=Confidence.INFERRED,
    )


def _wrong_drives(context: Context) -> Findings:
    """Drive plugins and controllers with wheels of the wrong side."""
    for use in context.plugins:
        yield from _wrong_plugin(use, context)
    for file, controller in context.controllers:
        for finding in _wrong_axles(controller, context):
            yield finding._replace(related=(file.note,))
        sides = controller.values(_LEFT), controller.values(_RIGHT)
        if "diff_drive" not in controller.type:
            continue
        for left, right in product(*sides):  # the first are often the front wheels
            joints = [context.model.joints_by_name.get(name.text) for name in (left, right)]
            first, second = (wheel_of(joint, context.tree) if joint else None for joint in joints)
            if first and second and (wrong := wrong_direction(first, second)):
                message = f"{controller.title}: {wrong[0]}"
                yield Finding(left.span, message, wrong[1], related=(file.note,))
                break


def _wrong_axles(controller: Controller, context: Context) -> Findings:
    """A list of a steering controller with swapped or inverted joints."""
    rolling: Wheel | None = None
    for right_name, right, left in sorted(_axles(controller, context), key=_is_steered):
        if not _is_steered((right_name, right, left)):
            rolling, wrong = left, wrong_direction(left, right, _SKIDS)
        else:
            wrong = wrong_steering(left, right, rolling) if rolling else None
        if wrong:
            message = f"{controller.title}: {wrong[0]}"
            help = f"{wrong[1]}; the list begins with the right joint"
            yield Finding(right_name.span, message, help)
            return


def _axles(controller: Controller, context: Context) -> Iterator[tuple[Value, Wheel, Wheel]]:
    """The lists of two joints: name of the right joint, right wheel, left wheel."""
    for parameter in _AXLES if controller.type.endswith("SteeringController") else ():
        names = controller.values([parameter])
        joints = (context.model.joints_by_name.get(name.text) for name in names)
        found = [wheel for joint in joints if joint and (wheel := wheel_of(joint, context.tree))]
        if len(found) == len(names) == 2:
            yield names[0], found[0], found[1]


def _is_steered(axle: tuple[Value, Wheel, Wheel]) -> bool:
    return min(abs(wheel.axis[2]) for wheel in axle[1:]) > _PARALLEL


def _wrong_plugin(use: PluginUse, context: Context) -> Findings:
    kind = drive_of(use)
    if kind is None or use.values("legacyMode"):
        return
    is_gz = use.plugin is not None and use.plugin.generation == "gz"
    rolling = list(pairs(list(wheels(use, context.tree)))) if is_gz or not kind.steered else []
    for left, right in rolling:
        if wrong := wrong_direction(left.wheel, right.wheel):
            other = Related(right.reference.item.at.span, "the right joint is named here")
            at, message = left.reference.item.at, f"{use.title}: {wrong[0]}"
            yield Finding(at, message, wrong[1], related=(other,))
            return
    steered = {ref.parameter.name: ref for ref in use.references() if rolling and kind.steered}
    sides = [steered.get(f"{side}_steering_joint") for side in ("left", "right")]
    joints = [context.model.joints_by_name.get(reference.name) for reference in sides if reference]
    found = [wheel for joint in joints if joint and (wheel := wheel_of(joint, context.tree))]
    if sides[0] and len(found) == 2:
        left_joint, right_joint = found
        if wrong := wrong_steering(left_joint, right_joint, rolling[0][0].wheel):
            yield Finding(sides[0].item.at, f"{use.title}: {wrong[0]}", wrong[1])


def _one_of_four(context: Context) -> Findings:
    """One of four wheels whose axis is opposite to the others."""
    joints = filter(_rolls, context.model.joints)
    axles = [(joint, axle) for joint in joints if (axle := _axle(context, joint))]
    if len(axles) != 4:
        return
    cosines = [dot(axles[0][1], axle) for _, axle in axles]
    if min(map(abs, cosines)) < _PARALLEL:
        return
    for sign in (1, -1):
        same = [joint for (joint, _), cos in zip(axles, cosines, strict=True) if cos * sign > 0]
        if len(same) == 1:
            yield Finding(
                _axis(same[0]),
                f"joint '{same[0].name}': the wheel axis is opposite to the other 3 wheels",
                "invert the <axis>",
                related=tuple(_note(joint) for joint, _ in axles if joint is not same[0]),
                confidence=Confidence.INFERRED,
            )


def _opposite(context: Context) -> Findings:
    """A single pair of wheels with opposite axes."""
    wheel_pairs = [pair for pair in context.symmetric_joints if all(map(_rolls, pair))]
    if len(wheel_pairs) != 1:
        return
    ((left, right),) = wheel_pairs
    left_axle, right_axle = _axle(context, left), _axle(context, right)
    axles = (_axle(context, joint) for joint in context.model.joints if _rolls(joint))
    if any(axle and left_axle and abs(dot(axle, left_axle)) < _PARALLEL for axle in axles):
        return  # the wheels of an omnidirectional robot, which may all point outwards
    if left_axle and right_axle and dot(left_axle, right_axle) < -_PARALLEL:
        yield Finding(
            _axis(right),
            f"joint '{right.name}': the wheel axis is opposite to that of '{left.name}'",
            "invert one <axis>, unless the driver of the robot inverts a sign",
            related=(_note(left),),
            confidence=Confidence.INFERRED,
            severity=Severity.INFO,
        )


def _axis(joint: Joint) -> Element:
    return joint.at.child_or_self("axis")


def _note(joint: Joint) -> Related:
    return Related(_axis(joint).span, f"joint '{joint.name}'")


def _rolls(joint: Joint) -> bool:
    """True for the continuous joint of a wheel that is not steered."""
    name = f"{joint.name} {joint.child_name}".lower()
    is_wheel = "wheel" in name and not any(word in name for word in _OTHERS)
    return is_wheel and joint.kind == "continuous" and joint.mimic is None


def _axle(context: Context, joint: Joint) -> Vector | None:
    """The axis of a joint in the root frame."""
    frame = context.tree.frames.get(joint.child_name)
    return rotate(frame.rotation, direction(joint)) if frame else None
