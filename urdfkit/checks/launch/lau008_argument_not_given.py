"""A launch file includes another one and leaves out an argument that has no default.

`roslaunch` stops with "requires the 'x' arg to be set", `ros2 launch` with "missing required
argument".

Sources:
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, include_launch_description.py: https://github.com/ros2/launch/blob/rolling/launch/launch/actions/include_launch_description.py
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Findings, Need, reported, rule
from urdfkit.text.diagnostic import Severity

NAME = "robot.launch"
BAD = """\
<launch>
  <include file="$(dirname)/world.launch"/>
</launch>
"""
GOOD = BAD.replace("/>", '><arg name="world" value="empty"/></include>')
FILES = {
    "world.launch": b'<launch><arg name="world"/><param name="w" value="$(arg world)"/></launch>'
}


@rule(Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Findings:
    yield from reported(subject, "LAU008")
