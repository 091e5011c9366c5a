"""A tag of a launch file lacks an attribute without which it means nothing.

`roslaunch` stops: "<node> tag is missing required attribute". `ros2 launch` stops, too: "Attribute
'exec' not found".

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
BAD = '<launch><node name="rviz" pkg="rviz" args="-d $(find rviz)/default.rviz"/></launch>'
GOOD = BAD.replace('pkg="rviz"', 'pkg="rviz" type="rviz"')


@rule("LAU009", "attribute-missing", Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    yield from reported(subject, "LAU009")
