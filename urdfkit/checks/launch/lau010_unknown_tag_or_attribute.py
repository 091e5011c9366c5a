"""A launch file has a tag or an attribute that launch does not know.

`ros2 launch` stops at it: "Unexpected attribute(s) found". `roslaunch` goes on and does not do what
was written. Many are slips; others belong to the other ROS, which calls the executable of a node
`type` (ROS 1) or `exec` (ROS 2). Packages may bring tags of their own: unknown tags are reported
only if they are nearly known ones.

Sources:
    roslaunch, xmlloader.py: https://github.com/ros/ros_comm/blob/noetic-devel/tools/roslaunch/src/roslaunch/xmlloader.py
    launch, entity.py: https://github.com/ros2/launch/blob/rolling/launch_xml/launch_xml/entity.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch"
BAD = '<launch><node name="rviz" pkg="rviz" type="rviz" respwan="true"/></launch>'
GOOD = BAD.replace("respwan", "respawn")


@rule("LAU010", "unknown-tag-or-attribute", Severity.WARNING, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    yield from reported(subject, "LAU010")
