"""An expression or a file access was refused because a model has no need of it.

xacro evaluates Python, and its own filter can be walked around: whoever expands a model runs its
author's code. Here expressions pass an allow-list (numbers, text, lists, comparisons, calls of
xacro's functions), and `$(env)` reads only variables of ROS and Gazebo. None of 14 081
expressions in public models is refused.

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
  <link name="${().__class__.__name__}"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="${str(1 + 1)}"/>
</robot>
"""


@rule(
    "XAC009",
    "unsafe-expression",
    Severity.ERROR,
    needs=(),
    help="write it with plain arithmetic; if you trust the model's author, add --trust",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC009")
