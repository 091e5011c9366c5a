"""A launch file uses a package that its own `package.xml` does not declare.

It works on the machine where that package happens to be. Elsewhere rosdep does not install it, and
launch stops: "package not found". Packages that come with ROS are not reported, nor those whose
declaration would make a cycle of packages.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Location, Need, rule
from urdfkit.text.diagnostic import Severity
from urdfkit.workspace.manifest import depends_on, manifest_of
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "bot_bringup/launch/bot.launch"
BAD = '<launch><node name="driver" pkg="bot_driver" type="driver"/></launch>'
GOOD = BAD.replace("bot_driver", "bot_control")
FILES = {
    "bot_bringup/package.xml": b"<package><name>bot_bringup</name>"
    b"<exec_depend>bot_control</exec_depend></package>",
    "bot_control/package.xml": b"<package><name>bot_control</name></package>",
    "bot_driver/package.xml": b"<package><name>bot_driver</name></package>",
}


@rule(Severity.INFO, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Findings:
    manifest = manifest_of(subject.resolver, subject.source.path)
    if manifest is None:
        return
    tag = manifest.dependency_tag
    reported = {manifest.package, *manifest.dependencies}
    for package in subject.launch.packages:
        is_own = package.span.source.path == subject.source.path
        if package.searched is not None or package.name in reported or not is_own:
            continue  # LAU002, and what included files of other packages use
        if comes_with_ros(package.name):
            continue
        near = subject.source.path
        if not depends_on(package.name, manifest.package, near, subject.resolver):
            yield Finding(
                Location(package.span),
                f"package '{package.name}' is used but not declared in {manifest.path}",
                f"add <{tag}>{package.name}</{tag}> to package.xml",
                alike="undeclared",
            )
