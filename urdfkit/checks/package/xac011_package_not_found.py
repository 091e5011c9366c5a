"""A ROS package that a robot or a launch file needs is not found.

Without the package a xacro cannot be expanded, and programs on this machine cannot load its meshes:
an error if the workspace has a package with nearly the same name, one for all meshes of a package.
What the xacro defines without the package is checked, if the places of its links are known; names
that the package may define are not reported as missing, unless they differ in a letter from others.
Other packages may be missing on this machine only, and exist where the robot runs: a warning. It is
an info if only meshes cannot be checked and `package.xml` declares the package, ROS has it, or a
submodule that is not checked out may contain it.
`roslaunch` stops with "ResourceNotFound", `ros2 launch` with "package not found": an info if
`package.xml` does not declare the package, and a warning if its name is a typo. Specify the
directory of the package, put it into the workspace, or source the ROS installation that has it.

Sources:
    xacro: https://wiki.ros.org/xacro
    URDF, link: https://wiki.ros.org/urdf/XML/link
    roslaunch, XML: http://wiki.ros.org/roslaunch/XML
    ros/xacro#329: https://github.com/ros/xacro/issues/329
    ros/xacro#359: https://github.com/ros/xacro/issues/359
"""

import os
import re
from collections.abc import Iterable, Mapping

from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean, is_typo
from urdfkit.errors import Unavailable
from urdfkit.lint.rules import Context, Finding, Findings, Severity, reported, rule
from urdfkit.robot.assets.file_names import is_mistyped
from urdfkit.robot.assets.mesh_files import MeshReference
from urdfkit.robot.samples import xacro_xml
from urdfkit.text.diagnostic import Problem
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Span
from urdfkit.workspace.manifest import is_known_dependency, manifest_of
from urdfkit.workspace.ros_packages import ros_packages

BAD = xacro_xml('<xacro:include filename="$(find arm_descripton)/urdf/arm.xacro"/>')
GOOD = xacro_xml('<link name="base"/>')

_NAME = r"^package '([^']+)'"
#: Longest path in a package.
_MAX_PATH = 300


@rule(
    Severity.ERROR,
    needs=(),
    help="name its directory with --package NAME=DIR, or add the package to the workspace",
)
def check(context: Context) -> Findings:
    problems = context.problems("XAC011")
    for problem, finding in zip(problems, reported(context, "XAC011"), strict=True):
        yield _explained(context, problem, finding)
    if is_launch(context.source.path):
        yield from _launched(context)
        return
    try:
        missing = context.files.without_package
    except Unavailable:  # the xacro cannot be expanded
        return
    for name, meshes in missing.items():
        if name:
            yield _of_meshes(context, name, meshes)


def _explained(context: Context, problem: Problem, finding: Finding) -> Finding:
    """The finding with what is known of the package: a typo, its declaration, its file."""
    (name,) = re.findall(_NAME, problem.message)
    path = problem.span.source.path
    known = context.resolver.packages.known(context.source.path)
    alike = _meant(name, known)
    alike += [package for package in known if package.rstrip("0123456789") == name]
    is_declared = is_known_dependency(name, path, context.resolver)
    severity = None if alike and not is_declared else Severity.WARNING
    reason = "is not found"
    if not is_declared and manifest_of(context.resolver, path) is not None:
        reason += " and not declared in package.xml"
    if severity and context.reading.document is None:
        is_part = context.part is not None
        part = "only the rest of the robot is" if is_part else "the robot is not"
        reason += f", so {part} checked"
    return finding._replace(
        message=finding.message.replace("is not found", reason, 1),
        help=finding.help
        + ("" if severity else did_you_mean(name, alike))
        + ("" if is_declared else _owner(name, _from(problem.span), known)),
        group_key=name,
        severity=severity,
    )


def _meant(name: str, known: Iterable[str]) -> list[str]:
    """The packages of the workspace and of ROS of which a name may be a typo."""
    return [
        *(package for package in known if is_mistyped(name, package)),
        *(package for package in sorted(ros_packages()) if is_typo(name, package)),
    ]


def _from(span: Span) -> str:
    """The text from the name of a package on, with the path in it."""
    return span.source.data[span.start : span.end + _MAX_PATH].decode("utf-8", "replace")


def _owner(name: str, text: str, known: Mapping[str, str]) -> str:
    """``, or write ...``: the only package with the file that is looked for in a missing one."""
    match = re.search(rf"{re.escape(name)}\)?/+([\w./-]+)", text)
    owners = [
        package
        for package, directory in known.items()
        if match and disk.is_file(os.path.join(directory, match.group(1)))
    ]
    if match is None or len(owners) != 1:
        return ""
    return f", or name package '{owners[0]}', which has '{match.group(1)}'"


def _of_meshes(context: Context, name: str, meshes: list[MeshReference]) -> Finding:
    """One finding for all meshes of a package."""
    first = meshes[0]
    is_declared = is_known_dependency(name, first.at.span.source.path, context.resolver)
    count = "1 mesh" if len(meshes) == 1 else f"{len(meshes)} meshes"
    known = context.resolver.packages.known(context.source.path)
    suggested = did_you_mean(name, _meant(name, known))
    is_model = first.located.scheme == "model"
    source = "add the directory around it to GAZEBO_MODEL_PATH or GZ_SIM_RESOURCE_PATH"
    source = source if is_model else "source the workspace that has it"
    return Finding(
        first.at,
        f"link '{first.link.name}': {'model' if is_model else 'package'} '{name}' is not found, "
        f"so {count} of it cannot be checked; searched: {', '.join(first.located.searched)}",
        f"pass its directory with --package {name}=DIR, or {source}"
        f"{suggested or ('' if is_declared else _owner(name, first.at.value, known))}",
        group_key=f"meshes of {name}",
        severity=None if suggested else Severity.INFO if is_declared else Severity.WARNING,
    )


def _launched(context: Context) -> Findings:
    path, resolver = context.source.path, context.resolver
    manifest, known = manifest_of(resolver, path), resolver.packages.known(path)
    for package in context.launch.packages:
        name = package.name
        if package.searched is None or is_known_dependency(name, path, resolver):
            continue
        suggested = did_you_mean(name, _meant(name, known))
        undeclared, help = "", "fix the name"
        if manifest is not None:
            undeclared = " and not declared in package.xml"
            help += f", or add <{manifest.dependency_tag}>{name}</{manifest.dependency_tag}>"
        yield Finding(
            package.span,
            f"package '{name}' is not found{undeclared}{suggested}; "
            f"searched: {', '.join(package.searched)}",
            help,
            group_key="" if suggested else "not found",
            severity=Severity.WARNING if suggested else Severity.INFO,
        )
