"""A plugin is given the name of a link that the robot does not have.

The plugin looks the link up in the simulated model; not finding it, it writes an error and stays
idle, and some plugins end the simulator. Xacro prefixes are a usual cause.

Sources:
    ros-simulation/gazebo_ros_pkgs#843: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/843
    osrf/vrx#867: https://github.com/osrf/vrx/issues/867
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
<link name="arm_link">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="pose" filename="libgazebo_ros_p3d.so">
    <bodyName>arm_lnk</bodyName>
    <topicName>arm_pose</topicName>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("arm_lnk", "arm_link")
FIXED = GOOD


@rule(
    "GAZ020",
    "parameter-names-unknown-link",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    help="name a link of this robot",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    return unknown(subject, "link")
