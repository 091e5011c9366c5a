"""A soft limit, a calibration position or position 0 is outside the limits of its joint.

- Soft limits slow a joint down before it reaches its stop, so they must be within `<limit>`.
  Outside of it they have no effect: the controllers of ros_control (ROS 1) brake at the stop
  itself, and MoveIt uses the narrower of both.
- urdfdom reads a missing `soft_lower_limit` or `soft_upper_limit` as 0. If the range between them
  is empty, MoveIt plans with a joint that can only be at 0, and ros_control holds it there.
- `rising` and `falling` of a `<calibration>` are the positions at which a sensor switches while the
  joint searches for its zero. If they are outside the limits, the search runs into the stop, or all
  positions have an offset afterwards.
- Simulators and inverse kinematics start joints at 0. If that is outside the limits, Gazebo moves
  the joint to its limit in the first step, and other programs start with a configuration that they
  then reject. The limits are often intended, as for an elbow that cannot be straightened: then set
  an initial position in the simulation, or rotate the origin of the joint so that 0 is within the
  limits. An info.

Sources:
    URDF, joint: https://wiki.ros.org/urdf/XML/joint
    ROS 1, safety limits: http://wiki.ros.org/pr2_controller_manager/safety_limits
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    ros_control, joint_limits_interface.h: https://github.com/ros-controls/ros_control/blob/noetic-devel/joint_limits_interface/include/joint_limits_interface/joint_limits_interface.h
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.robot.joint import Joint
from urdfkit.robot.joint_limits import SOFT_LIMITS, bounds, related, several, soft_bounds
from urdfkit.robot.model import RobotModel
from urdfkit.robot.samples import arm_xml
from urdfkit.robot.values import number
from urdfkit.text.document import Element

BAD = arm_xml(
    "revolute",
    '<limit lower="-1.5" upper="1.5" effort="30" velocity="1"/>',
    '<safety_controller soft_lower_limit="-1.6" soft_upper_limit="1.4" k_velocity="10"/>',
)
GOOD = BAD.replace("-1.6", "-1.4")

#: Tolerance for rounding as a part of the range: of a calibration, and of a soft limit.
_TOLERANCE, _ROUNDING = 1e-3, 1e-4

#: Part of the range by which 0 may be outside: a margin, not a defect.
_MARGIN = 0.01


class _Soft(Record):
    """The soft limits of a joint, and its limits."""

    joint: Joint
    at: Element
    soft: tuple[float, float]
    hard: tuple[float, float]

    @property
    def is_empty(self) -> bool:
        """True if no position is within both."""
        return max(self.soft[0], self.hard[0]) >= min(self.soft[1], self.hard[1])

    @property
    def is_outside(self) -> bool:
        allowed = _ROUNDING * (self.hard[1] - self.hard[0])
        return self.soft[0] < self.hard[0] - allowed or self.soft[1] > self.hard[1] + allowed

    @property
    def shown(self) -> str:
        return f"soft limits [{self.soft[0]:g}, {self.soft[1]:g}] {self.joint.unit}"


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    """One finding per defect of soft limits, and for 0: usually all joints have the same limits."""
    soft = list(_soft_limits(context.model))
    if outside := [limits for limits in soft if limits.is_outside and not limits.is_empty]:
        lower, upper = outside[0].hard
        reason = f"{outside[0].shown} exceed the limits [{lower:g}, {upper:g}]"
        yield _of_soft(outside, reason, "move the soft limits inwards")
    if empty := [limits for limits in soft if limits.is_empty and limits.hard[0] < limits.hard[1]]:
        missing = [key for key in SOFT_LIMITS if key not in empty[0].at.attributes]
        why = f" (missing: {', '.join(missing)})" if missing else ""
        reason = f"{empty[0].shown}{why} leave no range within the limits"
        yield _of_soft(empty, reason, "write both soft limits, within the limits")
    for joint in context.model.joints:
        yield from _calibration(joint)
    if joints := [joint for joint in context.model.joints if _excludes_zero(joint)]:
        lower, upper = bounds(joints[0]) or (0.0, 0.0)
        yield _finding(
            [(joint, joint.limit.at) for joint in joints if joint.limit],
            f"position 0 is outside the limits [{lower:g}, {upper:g}] {joints[0].unit}",
            "set an initial position, or rotate its origin so that 0 is within the limits",
        )._replace(severity=Severity.INFO)


def _soft_limits(model: RobotModel) -> Iterator[_Soft]:
    for joint in model.joints:
        at, soft, hard = joint.at.child("safety_controller"), soft_bounds(joint), bounds(joint)
        if at is not None and soft and hard:
            yield _Soft(joint, at, soft, hard)


def _of_soft(defects: list[_Soft], reason: str, help: str) -> Finding:
    places = [(limits.joint, limits.at) for limits in defects]
    return _finding(places, reason, f"{help}, or remove the <safety_controller>")


def _finding(places: list[tuple[Joint, Element]], reason: str, help: str) -> Finding:
    return Finding(
        places[0][1],
        f"{several([joint for joint, _ in places])}: {reason}",
        help,
        related=related((joint, at.span) for joint, at in places),
    )


def _excludes_zero(joint: Joint) -> bool:
    lower, upper = bounds(joint) or (0.0, 0.0)
    return not joint.mimic and max(lower, -upper) > _MARGIN * (upper - lower) > 0


def _calibration(joint: Joint) -> Findings:
    calibration, ends = joint.at.child("calibration"), bounds(joint)
    if calibration is None or ends is None or ends[0] >= ends[1]:
        return
    lower, upper = ends
    allowed = _TOLERANCE * (upper - lower)
    for edge in ("rising", "falling"):
        value = number(calibration.get(edge))
        if value is not None and not lower - allowed <= value <= upper + allowed:
            yield Finding(
                calibration.attributes[edge],
                f"joint '{joint.name}': {edge} edge at {value:g} {joint.unit} is outside the "
                f"limits [{lower:g}, {upper:g}]",
                f"correct {edge}, or the limits",
            )
