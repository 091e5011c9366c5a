"""A launch file uses an argument that it does not declare, and declares none that is like it.

It works if whoever starts it gives the argument. Otherwise launch stops: "launch configuration 'x'
does not exist", in ROS 1 "requires the 'x' arg to be set"; and a list of the file's arguments does
not name it. Declare it, without a default if it must be given. A file that others include may get
its arguments there, and is not reported.

Sources:
    launch, launch_configuration.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/launch_configuration.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch.py"
BAD = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import LaunchConfiguration


def generate_launch_description():
    return LaunchDescription([LogInfo(msg=LaunchConfiguration("side"))])
"""
GOOD = BAD.replace('"side"', '"side", default="left"')


@rule(
    "LAU012",
    "configuration-undeclared",
    Severity.WARNING,
    needs=(Need.LAUNCH,),
    help="declare it",
)
def check(subject: Subject) -> Iterator[Finding]:
    yield from reported(subject, "LAU012")
