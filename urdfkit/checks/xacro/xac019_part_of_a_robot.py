"""The file cannot be checked alone: it uses what the file that includes it defines.

Many robots are spread over files, and only the first of them is a robot. The others use macros,
properties and arguments that were defined before they are included. Checked alone they cannot be
expanded, which is no error. Check the file at the top instead: every finding in a part is sent to
the line of the part.

Sources:
    xacro: https://wiki.ros.org/xacro
    measured: 374 of 538 public xacro files hold macros only
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Findings, reported, rule
from urdfkit.text.diagnostic import Severity

FILES = {
    "whole.xacro": b"""\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" value="0.3"/>
  <xacro:include filename="example.urdf"/>
</robot>
"""
}
BAD = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="arm_${length}"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:property name="length" default="0.3"/>
  <link name="arm_${length}"/>
</robot>
"""


@rule(Severity.INFO, needs=(), help="check the file that includes this one")
def check(subject: Subject) -> Findings:
    return reported(subject, "XAC019")
