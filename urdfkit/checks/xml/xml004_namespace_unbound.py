"""A xacro file uses a prefix that it does not declare.

xacro reads XML with name spaces and stops with "unbound prefix". Mostly the root element of an
included file lacks its `xmlns:xacro`. Declare the prefix on the root element.

Sources:
    Namespaces in XML: https://www.w3.org/TR/xml-names/
    xacro, __init__.py: https://github.com/ros/xacro/blob/ros2/xacro/__init__.py
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Findings, reported, rule
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="r">
  <xacro:property name="length" value="0.3"/>
  <link name="arm_${length}"/>
</robot>
"""
FIXED = BAD.replace("<robot", '<robot xmlns:xacro="http://www.ros.org/wiki/xacro"')
GOOD = FIXED


@rule(
    Severity.ERROR,
    needs=(),
    help='declare it on the root element, such as xmlns:xacro="http://www.ros.org/wiki/xacro"',
)
def check(subject: Subject) -> Findings:
    return reported(subject, "XML004")
