"""A ROS package that the xacro needs was not found.

The expansion cannot go on without it. That the package is not on this machine does not mean that
the model is wrong: the message lists what was searched. Name the folder, put the package into the
workspace, or source the ROS installation that has it.

Sources:
    xacro: https://wiki.ros.org/xacro
    ros/xacro#329: https://github.com/ros/xacro/issues/329
    ros/xacro#359: https://github.com/ros/xacro/issues/359
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Findings, reported, rule
from urdfkit.text.diagnostic import Severity

BAD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:include filename="$(find arm_descripton)/urdf/arm.xacro"/>
</robot>
"""
GOOD = """\
<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <link name="base"/>
</robot>
"""


@rule(
    Severity.ERROR,
    needs=(),
    help="name its folder with --package NAME=DIR, or add the package to the workspace",
)
def check(subject: Subject) -> Findings:
    for finding in reported(subject, "XAC011"):
        yield finding._replace(alike=finding.help)  # which names the package
