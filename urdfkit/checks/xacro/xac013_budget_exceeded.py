"""The expansion exceeds a limit of depth, size or time.

Macros that call themselves, circular includes, a number with a million digits: limits of depth,
number of elements, size of values and time stop them, so that a hostile or broken file cannot block
the machine that checks it. They are a hundred times what the largest public robot needs.

Sources:
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
    measured: the largest public robot has 1 201 links
"""

from __future__ import annotations

from urdfkit.lint.rules import Findings, Severity, Subject, reported, rule

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="again" params="n"><xacro:again n="${n + 1}"/></xacro:macro>
  <xacro:again n="0"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="again" params="n">
    <xacro:if value="${n &lt; 3}"><xacro:again n="${n + 1}"/></xacro:if>
  </xacro:macro>
  <xacro:again n="0"/>
</robot>
"""


@rule(
    Severity.ERROR,
    needs=(),
    help="look for a macro, an include or a property that refers to itself",
)
def check(subject: Subject) -> Findings:
    return reported(subject, "XAC013")
