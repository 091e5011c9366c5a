"""A plugin does not read a tag that it is given.

Gazebo hands every tag to the plugin, and what the plugin does not ask for has no effect and causes
no message. Mostly it is left over from another plugin or version. Nothing is said about a few tags
that the shipped examples themselves give without need, such as `alwaysOn`.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

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
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <robotBaseFrame>base</robotBaseFrame>
    <enableYAxis>true</enableYAxis>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("    <enableYAxis>true</enableYAxis>\n", "")


@rule(
    "GAZ016",
    "unknown-parameter",
    Severity.INFO,
    needs=(Need.MODEL, Need.GAZEBO),
    help="remove it",
)
def check(subject: Subject) -> Iterator[Finding]:
    for use, found in subject.unread:
        if found.suggested is None and found.other is None:
            path = "> in <".join(reversed(found.item.path.split("/")))
            yield Finding(found.item.at, f"{use.title} does not read <{path}>", alike=use.filename)
