"""The soft limits of joints reach beyond their limits.

Soft limits slow a joint down before it runs into its stop, so they lie within `<limit>`. Outside
of it they never act: the controllers of ros_control (ROS 1) then brake at the stop itself, and
MoveIt takes the narrower of both. Move them inwards, or remove the `<safety_controller>`.

Sources:
    ROS 1, safety limits: http://wiki.ros.org/pr2_controller_manager/safety_limits
    ros_control, joint_limits_interface.h: https://github.com/ros-controls/ros_control/blob/noetic-devel/joint_limits_interface/include/joint_limits_interface/joint_limits_interface.h
    MoveIt, robot_model.cpp: https://github.com/moveit/moveit2/blob/main/moveit_core/robot_model/src/robot_model.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, rule
from urdfkit.robot.joints import bounds, related, several, soft_bounds, unit
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
  <safety_controller soft_lower_limit="-1.6" soft_upper_limit="1.4" k_velocity="10"/>
</joint>"""
GOOD = BAD.replace("-1.6", "-1.4")


@rule(
    "JNT019",
    "safety-limits-outside-limits",
    Severity.WARNING,
    help="move the soft limits inwards, or remove the <safety_controller>",
)
def check(subject: Subject) -> Iterator[Finding]:
    """One finding for all: the margin is mostly the same for every joint."""
    found = [
        (joint, soft, hard)
        for joint in subject.model.joints
        if (soft := soft_bounds(joint)) and (hard := bounds(joint))
        if soft[0] < hard[0] or soft[1] > hard[1]
        if max(soft[0], hard[0]) < min(soft[1], hard[1])  # else JNT029 tells
    ]
    if found:
        first, soft, hard = found[0]
        places = [
            (joint, (joint.at.child("safety_controller") or joint.at).span) for joint, *_ in found
        ]
        of = unit(first)
        yield Finding(
            first.at.child("safety_controller") or first.at,
            f"{several([joint for joint, *_ in found])}: the soft limits {soft[0]:g} to "
            f"{soft[1]:g} {of} reach beyond the limits {hard[0]:g} to {hard[1]:g} {of}",
            related=related(places),
        )
