"""A plugin is given the name of a joint that the robot does not have.

The plugin looks the joint up in the simulated model; not finding it, it writes an error and stays
idle, and some plugins end the simulator. Xacro prefixes are a usual cause.

Sources:
    ros-simulation/gazebo_ros_pkgs#609: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/609
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.checks.gazebo_plugins.unknown_references import unknown
from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<link name="wheel">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<joint name="wheel_joint" type="continuous">
  <parent link="base"/>
  <child link="wheel"/>
  <axis xyz="0 1 0"/>
</joint>
<gazebo>
  <plugin name="states" filename="libgazebo_ros_joint_state_publisher.so">
    <jointName>wheel_jont</jointName>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("wheel_jont", "wheel_joint")
FIXED = GOOD


@rule(
    "GAZ021",
    "parameter-names-unknown-joint",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name a joint of this robot",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    return unknown(subject, "joint")
