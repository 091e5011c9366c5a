"""A ROS package that a xacro or a launch file needs is not found.

The expansion cannot go on without it: an error, or a warning if `package.xml` declares the package
or ROS has it, since only this machine then lacks it. `roslaunch` stops with "ResourceNotFound",
`ros2 launch` with "package not found": an info where `package.xml` does not declare the package,
and a warning where its name is a typo. Name the directory of the package, put it into the
workspace, or source the ROS installation that has it.

Sources:
    xacro: https://wiki.ros.org/xacro
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    ros/xacro#329: https://github.com/ros/xacro/issues/329
    ros/xacro#359: https://github.com/ros/xacro/issues/359
"""

from __future__ import annotations

import re

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, reported, rule
from urdfkit.robot.assets.mesh_files import is_typo
from urdfkit.text.diagnostic import Severity
from urdfkit.text.xml_reader import is_launch
from urdfkit.workspace.manifest import is_known_dependency, manifest_of

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

_NAME = re.compile(r"^package '([^']+)'")


@rule(
    Severity.ERROR,
    needs=(),
    help="name its folder with --package NAME=DIR, or add the package to the workspace",
)
def check(subject: Subject) -> Findings:
    for problem, finding in zip(
        subject.problems("XAC011"), reported(subject, "XAC011"), strict=True
    ):
        (name,) = _NAME.findall(problem.message)
        is_known = is_known_dependency(name, problem.span.source.path, subject.resolver)
        severity = Severity.WARNING if is_known else None
        # The help names the package.
        yield finding._replace(alike=finding.help, severity=severity)
    if is_launch(subject.source.path):
        yield from _launched(subject)


def _launched(subject: Subject) -> Findings:
    manifest = manifest_of(subject.resolver, subject.source.path)
    path, resolver = subject.source.path, subject.resolver
    known = resolver.packages.known(path)
    for package in subject.launch.packages:
        name = package.name
        if package.searched is None or is_known_dependency(name, path, resolver):
            continue
        suggested = did_you_mean(name, [one for one in known if is_typo(name, one)])
        undeclared, help = "", "fix the name"
        if manifest is not None:
            undeclared = " and not declared in package.xml"
            help += f", or add <{manifest.dependency_tag}>{name}</{manifest.dependency_tag}>"
        yield Finding(
            Location(package.span),
            f"package '{name}' is not found{undeclared}{suggested}",
            f"{help}; searched {', '.join(package.searched)}",
            alike="" if suggested else "not found",
            severity=Severity.WARNING if suggested else Severity.INFO,
        )
