"""A function of xacro is called without its name space.

xacro moved `load_yaml`, `sorted` and others into the name spaces `xacro` and `python`; the bare
names print a warning today and will be gone one day.

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
  <link name="l${sorted([3, 1])[0]}"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="l${python.sorted([3, 1])[0]}"/>
</robot>
"""
FIXED = GOOD


@rule(
    "XAC015",
    "deprecated-syntax",
    Severity.INFO,
    needs=(),
    help="write the function with its name space",
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC015")
