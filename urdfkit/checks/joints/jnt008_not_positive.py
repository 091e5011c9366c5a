"""An effort or velocity limit is zero or negative, or damping or friction is negative.

A limit of 0 is a limit. Gazebo and ros2_control clamp every effort command to 0, and in PyBullet a
motor command with the URDF's limit has no effect. ros2_control and DART, Gazebo's default physics
engine, stop a joint with a velocity limit of 0, even against gravity; MoveIt reads it as "no limit"
and then cannot time a trajectory. CAD exporters write 0 for "unknown". If some joints have a
transmission or ros2_control, joints without one are passive and are not reported; nor are casters
and rollers, which have no motor, for their effort, nor the only continuous joint with an effort of
0 and a velocity above it, next to joints with an effort: it is the passive joint of a pendulum.

A negative limit is an error: Pinocchio rejects the robot, Drake aborts on a negative velocity,
ros2_control and MoveIt drop the sign. Gazebo reads it as "no limit": it is a warning if the robot
is for Gazebo alone, and neither a transmission nor ros2_control drives the joint. Write what the
motor can deliver, or a generous limit if you do not know it.

Damping and friction dissipate energy; negative values add energy, and the joint accelerates by
itself. Drake rejects a negative damping, Pinocchio a negative friction.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    unitreerobotics/unitree_ros#154: https://github.com/unitreerobotics/unitree_ros/issues/154
    agilexrobotics/ugv_gazebo_sim#47: https://github.com/agilexrobotics/ugv_gazebo_sim/issues/47
    ros2_control, joint limiting: https://github.com/ros-controls/ros2_control/blob/master/hardware_interface/doc/joint_limiting.rst
    MoveIt, time parameterization: https://github.com/moveit/moveit2/blob/main/moveit_core/trajectory_processing/src/time_optimal_trajectory_generation.cpp
    Pinocchio, URDF joints: https://github.com/stack-of-tasks/pinocchio/blob/devel/include/pinocchio/parsers/urdf/model.hxx
    Drake, URDF parser: https://github.com/RobotLocomotion/drake/blob/master/multibody/parsing/detail_urdf_parser.cc
    Pinocchio, URDF model: https://github.com/stack-of-tasks/pinocchio/blob/devel/src/parsers/urdf/model.cpp
    sdformat, parser_urdf.cc: https://github.com/gazebosim/sdformat/blob/main/src/parser_urdf.cc
"""

from collections.abc import Collection

from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import can_move, driven, is_passive, limits_of, related, several
from urdfkit.robot.placed import Placed
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.ros.targets import GAZEBO, ROS, Targets

LimitOfJoint = tuple[Joint, Placed[float]]

BAD = arm_xml("revolute", '<limit lower="0" upper="1.7453" effort="0" velocity="2"/>')
GOOD = BAD.replace('effort="0"', 'effort="1.2"')

_HELP = {
    "effort": "write the force or torque that the motor can deliver",
    "velocity": "write the maximum speed of the joint",
}


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    """One finding per kind of limit: exporters write the same number for every joint."""
    joints = [joint for joint in context.model.joints if joint.is_single_dof]
    active = driven(context.model)
    reads_none = _is_for_gazebo_alone(context.targets)
    for key in _HELP:
        limits = limits_of(joints, key)
        if zero := _zero(limits, key, active):
            yield _finding(zero, key, "0", Severity.WARNING)
        negative = [(joint, limit) for joint, limit in limits if limit.value < 0]
        if negative:
            is_none = reads_none and all(joint.name not in active for joint, _ in negative)
            severity = Severity.WARNING if is_none else Severity.ERROR
            yield _finding(negative, key, f"{negative[0][1].value:g}", severity)
    for joint in context.model.joints:
        yield from _negative_dynamics(joint)


def _zero(limits: list[LimitOfJoint], key: str, active: Collection[str]) -> list[LimitOfJoint]:
    """The limits of 0 of joints with a motor; without drives, of all but the passive ones."""
    zero = [
        (joint, limit)
        for joint, limit in limits
        if limit.value == 0 and can_move(joint) and joint.mimic is None
    ]
    if active:
        return [(joint, limit) for joint, limit in zero if joint.name in active]
    if key != "effort":
        return zero
    zero = [(joint, limit) for joint, limit in zero if not is_passive(joint, active)]
    is_pendulum = len(zero) == 1 and _turns_freely(zero[0][0])
    return [] if is_pendulum and any(limit.value > 0 for _, limit in limits) else zero


def _turns_freely(joint: Joint) -> bool:
    """True for a continuous joint with a velocity limit above 0."""
    velocity = joint.limit.velocity if joint.limit else None
    return joint.kind == "continuous" and velocity is not None and velocity.value > 0


def _is_for_gazebo_alone(targets: Targets) -> bool:
    """True if no target reads a negative limit otherwise than as "no limit"."""
    programs = {name for name in targets.names if name not in ROS}
    return bool(programs) and programs <= set(GAZEBO)


def _finding(limits: list[LimitOfJoint], key: str, value: str, severity: Severity) -> Finding:
    first, limit = limits[0]
    in_unit = first.effort_unit if key == "effort" else f"{first.unit}/s"
    sign = ", below 0" if limit.value < 0 else ""
    return Finding(
        limit,
        f"{several([joint for joint, _ in limits])}: {key} limit is {value} {in_unit}{sign}",
        _HELP[key],
        related=related((joint, limit.span) for joint, limit in limits),
        severity=severity,
    )


def _negative_dynamics(joint: Joint) -> Findings:
    dynamics = joint.at.child("dynamics")
    effort = joint.effort_unit
    for key, in_unit in (("damping", f"{effort}·s/{joint.unit}"), ("friction", effort)):
        value = number(dynamics.get(key)) if dynamics else None
        if dynamics and value is not None and value < 0:
            message = f"joint '{joint.name}': the {key} is {value:g} {in_unit}, below 0"
            help = "write a positive number, or 0 for none"
            yield Finding(dynamics.attributes[key], message, help, severity=Severity.ERROR)
