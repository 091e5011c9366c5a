"""A ROS package that a xacro or a launch file needs is not found.

The expansion cannot go on without it: an error. `roslaunch` stops with "ResourceNotFound",
`ros2 launch` with "package not found": a warning, unless the package comes with ROS or
`package.xml` declares it. That the package is not on this machine does not mean that the model is
wrong: the message lists what was searched. Name its directory, put the package into the workspace,
or source the ROS installation that has it.

Sources:
    xacro: https://wiki.ros.org/xacro
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    ros/xacro#329: https://github.com/ros/xacro/issues/329
    ros/xacro#359: https://github.com/ros/xacro/issues/359
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, reported, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.text.xml_reader import is_launch
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.ros_packages import comes_with_ros

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
    if is_launch(subject.source.path):
        yield from _launched(subject)


def _launched(subject: Subject) -> Findings:
    manifest = manifest_of(subject.resolver, subject.source.path)
    declared = manifest.dependencies if manifest else frozenset()
    for package in subject.launch.packages:
        known = comes_with_ros(package.name) or package.name in declared
        if package.searched is not None and not known:
            yield Finding(
                Location(package.span),
                f"package '{package.name}' is not found",
                "fix the name, or declare the package in package.xml; searched "
                + ", ".join(package.searched),
                alike="not found",
                severity=Severity.WARNING,
            )
