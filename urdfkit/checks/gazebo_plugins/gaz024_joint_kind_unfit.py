"""A drive plugin turns a joint that is not a wheel.

A drive sets a velocity and expects the joint to turn for ever: a revolute joint stops at its
limits, and a prismatic one slides. Make the wheel's joint `continuous`.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gz-sim, DiffDrive.cc: https://github.com/gazebosim/gz-sim/blob/main/src/systems/diff_drive/DiffDrive.cc
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.gazebo.drives import drive_of, driven
from urdfkit.ros.gazebo.samples import WHEELED
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

GOOD = (
    WHEELED
    + """\
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_diff_drive.so">
    <leftJoint>left_joint</leftJoint>
    <rightJoint>right_joint</rightJoint>
  </plugin>
</gazebo>"""
)
BAD = GOOD.replace("continuous", "revolute").replace(
    "</joint>", '  <limit lower="-3" upper="3" effort="10" velocity="10"/>\n</joint>'
)


@rule(
    "GAZ024",
    "joint-kind-unfit",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="make the joint continuous, or name the joint of the wheel",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if drive_of(use) is None:
            continue
        for reference in driven(use):
            joint = subject.model.joints_by_name.get(reference.name)
            if joint is None or "steer" in reference.parameter.name.lower():
                continue
            if joint.kind in ("revolute", "prismatic", "floating", "planar"):
                yield Finding(
                    reference.item.at,
                    f"{use.title} turns joint '{joint.name}' as a wheel, and it is {joint.kind}",
                )
