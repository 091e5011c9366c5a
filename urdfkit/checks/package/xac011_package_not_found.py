"""A ROS package that a robot or a launch file needs is not found.

Without it a xacro cannot be expanded, and no program here can load its meshes: an error, one for
all meshes of a package. `roslaunch` stops with "ResourceNotFound", `ros2 launch` with "package not
found": a warning, unless the package comes with ROS or `package.xml` declares it. That the package
is not on this machine does not mean that the model is wrong: the message lists what was searched.
Name its directory, put the package into the workspace, or source the ROS installation that has it.

Sources:
    xacro: https://wiki.ros.org/xacro
    URDF, link: https://wiki.ros.org/urdf/XML/link
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    ros/xacro#329: https://github.com/ros/xacro/issues/329
    ros/xacro#359: https://github.com/ros/xacro/issues/359
"""

from __future__ import annotations

from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.context import Subject, Unavailable
from urdfkit.lint.rules import Finding, Findings, Location, reported, rule
from urdfkit.robot.assets.mesh_files import MeshReference, is_typo
from urdfkit.text.diagnostic import Severity
from urdfkit.text.file_kinds import is_launch
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
        return
    try:
        missing = subject.files.without_package
    except Unavailable:  # the xacro cannot be expanded
        return
    for name, meshes in missing.items():
        if name:
            yield _of_meshes(subject, name, meshes)


def _of_meshes(subject: Subject, name: str, meshes: list[MeshReference]) -> Finding:
    """One finding for all meshes of a package."""
    first = meshes[0]
    count = "1 mesh" if len(meshes) == 1 else f"{len(meshes)} meshes"
    known = subject.resolver.packages.known(subject.source.path)
    suggested = did_you_mean(name, [package for package in known if is_typo(name, package)])
    return Finding(
        first.at,
        f"link '{first.link}': package '{name}' is not found, so {count} of it cannot be checked; "
        f"searched {', '.join(first.located.searched)}",
        f"pass its directory with --package {name}=DIR, or source the workspace that has it"
        f"{suggested}",
    )


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
