"""The soft limits of joints leave them no room.

`soft_lower_limit` and `soft_upper_limit` are 0 for urdfdom where they are not written. MoveIt then
plans with a joint that may only stand at 0, and the controllers of ros_control (ROS 1) hold it
there. Write both, a little within the limits, or remove the `<safety_controller>`.

Sources:
    urdfdom, joint.cpp: https://github.com/ros/urdfdom/blob/rolling/urdf_parser/src/joint.cpp
    ROS 1, safety limits: http://wiki.ros.org/pr2_controller_manager/safety_limits
    ros_control, joint_limits_interface.h: https://github.com/ros-controls/ros_control/blob/noetic-devel/joint_limits_interface/include/joint_limits_interface/joint_limits_interface.h
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import SOFT_LIMITS, bounds, related, several, soft_bounds, unit
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base"/>
<link name="arm"/>
<joint name="shoulder" type="revolute">
  <parent link="base"/>
  <child link="arm"/>
  <limit lower="-1.5" upper="1.5" effort="30" velocity="1"/>
  <safety_controller k_position="20" k_velocity="10"/>
</joint>"""
GOOD = BAD.replace(
    "<safety_controller", '<safety_controller soft_lower_limit="-1.4" soft_upper_limit="1.4"'
)


@rule(
    "JNT029",
    "empty-soft-range",
    Severity.WARNING,
    help="write both soft limits, a little within the limits",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for all: who leaves them out for one joint, mostly does so for every other."""
    found = [
        (joint, safety, soft)
        for joint in subject.model.joints
        if (soft := soft_bounds(joint)) and (hard := bounds(joint))
        if hard[0] < hard[1] and max(soft[0], hard[0]) >= min(soft[1], hard[1])
        if (safety := joint.at.child("safety_controller"))
    ]
    if found:
        first, safety, soft = found[0]
        missing = [key for key in SOFT_LIMITS if key not in safety.attributes]
        why = f" (not written: {', '.join(missing)})" if missing else ""
        yield Finding(
            safety,
            f"{several([joint for joint, *_ in found])}: the soft limits {soft[0]:g} to "
            f"{soft[1]:g} {unit(first)}{why} leave no room within the limits",
            related=related((joint, at.span) for joint, at, _ in found),
        )
