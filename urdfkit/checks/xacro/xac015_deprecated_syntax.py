"""A function of xacro is called without its name space.

xacro moved `load_yaml`, `sorted` and others into the name spaces `xacro` and `python`; the bare
names print a warning today and will be gone one day.

Sources:
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Findings, reported, rule
from urdfkit.text.diagnostic import Severity

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


@rule(Severity.INFO, needs=(), help="write the function with its name space")
def check(subject: Subject) -> Findings:
    return reported(subject, "XAC015")
