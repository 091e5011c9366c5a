"""A launch file uses an argument that nothing declares.

`roslaunch` stops with "requires the 'x' arg to be set", `ros2 launch` with "launch configuration
'x' does not exist". Its name differs from the declared one, or the declaration is missing or comes
too late. Only slips of declared names, and what an including file does not pass, are reported here.

Sources:
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML/arg
    launch, launch_configuration.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/launch_configuration.py
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
  <arg name="use_gui" default="true"/>
  <node name="rviz" pkg="rviz" type="rviz" if="$(arg use_giu)"/>
</launch>
"""
GOOD = BAD.replace("use_giu", "use_gui")


@rule(
    "LAU006",
    "undeclared-argument",
    Severity.ERROR,
    needs=(Need.LAUNCH,),
    help="declare it, or fix the name",
)
def check(subject: Subject) -> Iterator[Finding]:
    yield from reported(subject, "LAU006")
