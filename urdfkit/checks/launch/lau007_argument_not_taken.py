"""A launch file passes an argument to another one that does not have it.

`roslaunch` stops with "unused args"; in ROS 2 nobody reads the value, and the included file goes on
with its default. The name differs, or the included file has lost the argument.

Sources:
    roslaunch, loader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/loader.py
    launch, include_launch_description.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/include_launch_description.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch"
BAD = """\
<launch>
  <include file="$(dirname)/world.launch">
    <arg name="gui" value="false"/>
  </include>
</launch>
"""
GOOD = BAD.replace("gui", "with_gui")
FILES = {"world.launch": b'<launch><arg name="with_gui" default="true"/></launch>'}


@rule(
    "LAU007",
    "argument-not-taken",
    Severity.WARNING,
    needs=(Need.LAUNCH,),
    help="pass an argument that the file has",
)
def check(subject: Subject) -> Iterator[Finding]:
    for finding in reported(subject, "LAU007"):
        _, _, argument = finding.message.partition(" has no ")
        yield finding._replace(alike=argument)
