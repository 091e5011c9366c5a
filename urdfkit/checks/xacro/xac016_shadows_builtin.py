"""A property takes the name of something that expressions already have.

xacro knows `pi`, `e`, `radians`, `sin`, `min`, `len` and the other names of Python's math module.
A property of the same name hides it in every file that is included afterwards; with `e` or `pi`
that gives wrong numbers far from here. xacro prints "redefining global symbol".

Sources:
    xacro: https://wiki.ros.org/xacro
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
  <xacro:property name="e" value="0.2"/>
  <link name="l${e}"/>
</robot>
"""
GOOD = BAD.replace('name="e"', 'name="edge"').replace("${e}", "${edge}")


@rule(
    "XAC016",
    "shadows-builtin",
    Severity.WARNING,
    needs=(),
    help="rename the property; for pi simply delete it, xacro has it exactly",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC016")
