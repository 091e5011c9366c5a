"""A launch file needs a package that is not found and that its own package does not declare.

`roslaunch` stops with "ResourceNotFound", `ros2 launch` with "package not found". Packages that
come with ROS are known by name, and packages that `package.xml` declares are somebody else's to
install: neither is reported.

Sources:
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, Need, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "robot.launch"
BAD = '<launch><node name="states" pkg="arm_states" type="joint_state_publisher"/></launch>'
GOOD = BAD.replace("arm_states", "joint_state_publisher")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Findings:
    manifest = manifest_of(subject.resolver, subject.source.path)
    declared = manifest.dependencies if manifest else frozenset()
    for package in subject.launch.packages:
        known = comes_with_ros(package.name) or package.name in declared
        if package.searched is not None and not known:
            searched = ", ".join(package.searched)
            place = Location(package.span)
            yield Finding(
                place,
                f"package '{package.name}' is not found",
                f"fix the name, or declare the package in package.xml; searched {searched}",
                alike="lost",
            )
