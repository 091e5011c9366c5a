"""Expanding the file gives a warning.

An attribute that the xacro tag does not know, an include whose pattern matches no file, or a
warning that the model's author wrote with `xacro.warning()`. xacro goes on, and the line is easily
lost in the output of a launch.

Sources:
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="a" value="1" unit="m"/>
  <link name="l${a}"/>
</robot>
"""
GOOD = BAD.replace(' unit="m"', "")


@rule(
    "XAC017",
    "xacro-warning",
    Severity.WARNING,
    needs=(),
    help="see the message; xacro ignores what it does not know",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC017")
