"""A soft limit or calibration position is outside the limits of its joint.

Soft limits slow a joint down before it reaches its stop, so they must be within `<limit>`.

- Soft limits outside of it have no effect: the controllers of ros_control (ROS 1) brake at the stop
  itself, and MoveIt uses the narrower of both.
- urdfdom reads a missing `soft_lower_limit` or `soft_upper_limit` as 0. If the range between them
  is empty, MoveIt plans with a joint that can only be at 0, and ros_control holds it there.
- `rising` and `falling` of a `<calibration>` are the positions at which a sensor switches while the
  joint searches for its zero. If they are outside the limits, the search runs into the stop, or all
  positions have an offset afterwards.

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
from urdfkit.robot.joints import SOFT_LIMITS, bounds, related, several, soft_bounds, unit
from urdfkit.robot.model import Joint, RobotModel
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
        return f"soft limits [{self.soft[0]:g}, {self.soft[1]:g}] {unit(self.joint)}"


@rule(Severity.WARNING)
def check(context: Context) -> Findings:
    """One finding per defect of soft limits: usually all joints have the same margin."""
    soft = list(_soft_limits(context.model))
    if outside := [limits for limits in soft if limits.is_outside and not limits.is_empty]:
        lower, upper = outside[0].hard
        reason = f"{outside[0].shown} exceed the limits [{lower:g}, {upper:g}]"
        yield _finding(outside, reason, "move the soft limits inwards")
    if empty := [limits for limits in soft if limits.is_empty and limits.hard[0] < limits.hard[1]]:
        missing = [key for key in SOFT_LIMITS if key not in empty[0].at.attributes]
        why = f" (missing: {', '.join(missing)})" if missing else ""
        reason = f"{empty[0].shown}{why} leave no range within the limits"
        yield _finding(empty, reason, "write both soft limits, within the limits")
    for joint in context.model.joints:
        yield from _calibration(joint)


def _soft_limits(model: RobotModel) -> Iterator[_Soft]:
    for joint in model.joints:
        at, soft, hard = joint.at.child("safety_controller"), soft_bounds(joint), bounds(joint)
        if at is not None and soft and hard:
            yield _Soft(joint, at, soft, hard)


def _finding(defects: list[_Soft], reason: str, help: str) -> Finding:
    return Finding(
        defects[0].at,
        f"{several([limits.joint for limits in defects])}: {reason}",
        f"{help}, or remove the <safety_controller>",
        related=related((limits.joint, limits.at.span) for limits in defects),
    )


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
                f"joint '{joint.name}': {edge} edge at {value:g} {unit(joint)} is outside the "
                f"limits [{lower:g}, {upper:g}]",
                f"correct {edge}, or the limits",
            )
