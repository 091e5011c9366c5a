"""A plain URDF holds tags of xacro that nobody expands.

Readers of URDF pass over `<xacro:...>` without a word: what the macro would have made, a camera or
a sensor's plugin, is missing from the robot. Either the file is a piece of a xacro, which another
file includes and which must declare `xmlns:xacro`, or the calls are left over from an expansion.

Sources:
    xacro: https://wiki.ros.org/xacro
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
  <link name="base"/>
  <xacro:camera parent="base"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="camera" params="parent">
    <link name="camera"/>
    <joint name="mount" type="fixed"><parent link="${parent}"/><child link="camera"/></joint>
  </xacro:macro>
  <link name="base"/>
  <xacro:camera parent="base"/>
</robot>
"""


@rule(
    "XAC018",
    "unexpanded-tag",
    Severity.WARNING,
    needs=(),
    help="include the file that defines the macro, or delete the call",
)
def check(subject: Subject) -> Iterator[Finding]:
    return reported(subject, "XAC018")
