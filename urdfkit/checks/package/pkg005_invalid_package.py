"""The package.xml of the robot's package is invalid.

The package is not built or not found: no file of the robot is installed, and `package://` does not
resolve.

- catkin and colcon stop at an invalid package.xml, or ignore the package: a required element is
  missing, a tag belongs to another format, or the file is not XML. A file with little more than a
  name is assumed to be the stub of a test.
- The `<build_type>` needs another build file than the package has: colcon does not build it.
- A package of ROS 2 depends on one that only ROS 1 has, such as rospy, or writes hyphens in the
  name of a ROS package (warning).

Only launch files, with the packages of the nodes that they start, and descriptions that refer to
packages are checked.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
    catkin_pkg, package.py: https://github.com/ros-infrastructure/catkin_pkg/blob/master/src/catkin_pkg/package.py
"""

import os
import re

from urdfkit.checks.package.build_files import (
    package_file,
    packages_to_build,
    packages_with_interfaces,
    refers_to_packages,
)
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.ros.catalog import data
from urdfkit.text.comments import blank_comments
from urdfkit.text.document import Element
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.manifest import REQUIRED, known_tags, nearest_manifest
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "urdf/bot.urdf"
BAD = robot_of_package("bot_description")
GOOD = BAD.replace("package://bot_description", "..")
_MANIFEST = b"""\
<package format="3">
  <name>bot_description</name>
  <version>1.0.0</version>
  <description>A bot.</description>
  <maintainer email="bot@example.org">Bot</maintainer>
  <license>MIT</license>
  <run_depend>xacro</run_depend>
</package>
"""
FILES = {"package.xml": _MANIFEST, "meshes/base.stl": PLATE}

#: Of each build type its build file, and that of the other.
_BUILT_BY = {
    "ament_cmake": ("CMakeLists.txt", "setup.py"),
    "ament_python": ("setup.py", "CMakeLists.txt"),
}
#: The codes of XML that is not well-formed.
_BROKEN = ("XML001", "XML002")


@rule(Severity.ERROR, help="fix the package.xml")
def check(context: Context) -> Findings:
    path, resolver = context.source.path, context.resolver
    if not refers_to_packages(context):
        return
    for directory in packages_to_build(context).values():
        yield from _other_build_type(directory)
    manifests = [os.path.join(home, "package.xml") for home in packages_with_interfaces(context)]
    for file in filter(None, (*manifests, nearest_manifest(path))):
        yield from _of_manifest(file, resolver)


def _other_build_type(directory: str) -> Findings:
    """A build type whose build file is missing, although that of another type exists."""
    manifest = package_file(directory, "package.xml")
    if manifest is None or b"<build_type" not in manifest.data:
        return
    data = bytes(blank_comments(manifest.data))
    match = re.search(rb"<build_type\b[^<>]*>\s*(\w+)\s*<", data)
    if match is None or len(re.findall(rb"<build_type\b", data)) > 1:
        return
    kind = match.group(1).decode()
    needed, other = _BUILT_BY.get(kind, ("", ""))
    has = {file: disk.exists(os.path.join(directory, file)) for file in (needed, other)}
    if needed and not has[needed] and has[other]:
        yield Finding(
            Span(manifest, *match.span(1)),
            f"build type {kind} needs a {needed}, and the package has a {other}",
            "write " + next(command for command, (file, _) in _BUILT_BY.items() if file == other),
        )


def _of_manifest(file: str, resolver: Resolver) -> Findings:
    """Mistakes in a package.xml."""
    if disk.is_link(file):  # which may refer to any file
        return
    try:
        data = resolver.text(file)
        source = Source.read(file) if data is None else Source(file, data)
    except UnreadableFile:
        return
    document, problems = read_xml(source)
    broken = [problem for problem in problems if problem.code in _BROKEN]
    for problem in broken[:1]:
        yield Finding(problem.span, f"package.xml is not valid XML: {problem.message}")
    if document is None or broken or document.root.tag != "package":
        return
    if not {"description", "maintainer", "license"} & {c.tag for c in document.root.children}:
        return
    yield from _missing(document.root)
    yield from _tags(document.root)
    yield from _values(document.root)
    yield from _of_ros_1(document.root)


def _missing(package: Element) -> Findings:
    tags = [child.tag for child in package.children]
    for tag in REQUIRED:
        if tag not in tags:
            yield Finding(package.span, f"the package has no <{tag}>", f"write a <{tag}>")
    for tag in ("name", "version", "description", "export"):
        for again in package.all(tag)[1:]:
            yield Finding(again.span, f"duplicate <{tag}>", "keep one")


def _tags(package: Element) -> Findings:
    """Tags that the format of the file does not define."""
    known = known_tags(package.get("format"))
    renamed = {"run_depend": "exec_depend", "exec_depend": "run_depend"}
    for child in package.children:
        if not known or child.tag in known:
            continue
        suggested = renamed.get(child.tag) or nearest(child.tag, known)
        of_later = 'write format="3"' if child.tag in known_tags("3") else "remove it"
        help = f"write <{suggested}>" if suggested in known else of_later
        number = package.get("format") or "1"
        yield Finding(child.span, f"<{child.tag}> is not a tag of format {number}", help)


def _of_ros_1(package: Element) -> Findings:
    """Dependencies of a package of ROS 2 that it does not have, or under another name."""
    kinds = [kind for export in package.all("export") for kind in export.all("build_type")]
    is_ament = [kind.text.strip() for kind in kinds] in (["ament_cmake"], ["ament_python"])
    if not is_ament or any(kind.attributes for kind in kinds):
        return
    former: dict[str, str] = data("packages")["former"]
    for child in package.children:
        name = child.text.strip()
        if not child.tag.endswith("depend") or "condition" in child.attributes:
            continue
        if name in former:
            successor = former[name]
            help = f"write {successor}" if successor else "remove it"
            message = f"<{child.tag}> {name}: ROS 2 has no package of this name"
            yield Finding(child.span, message, help, severity=Severity.WARNING)
        elif comes_with_ros(name.replace("-", "_")) and not comes_with_ros(name):
            message = f"<{child.tag}> {name}: the name of the package has underscores"
            help = f"write {name.replace('-', '_')}"
            yield Finding(child.span, message, help, severity=Severity.WARNING)


def _values(package: Element) -> Findings:
    name, version = package.child("name"), package.child("version")
    if name and not _is_name(name.text.strip()):
        message = f"'{name.text.strip()}' is not a valid package name"
        help = "write lower-case letters, digits and underscores, also in CMakeLists.txt"
        yield Finding(name.span, message, help)
    if version and not _is_version(version.text.strip()):
        message = f"version '{version.text.strip()}' does not have three numbers"
        yield Finding(version.span, message, "write it as 1.0.0")
    for maintainer in package.all("maintainer"):
        if not maintainer.get("email"):
            yield Finding(maintainer.span, "the maintainer has no email", 'write email="..."')
    for child in package.all("license"):
        if not child.text.strip():
            yield Finding(child.span, "the license is empty", "name the licence")
    own = name.text.strip() if name else ""
    for child in package.children:
        if own and child.tag.endswith("depend") and child.text.strip() == own:
            yield Finding(child.span, "the package depends on itself", "remove it")


def _is_name(text: str) -> bool:
    return text[:1].isalnum() and text.replace("_", "").replace("-", "").isalnum()


def _is_version(text: str) -> bool:
    numbers = text.split(".")
    return len(numbers) == 3 and all(map(str.isdecimal, numbers))
