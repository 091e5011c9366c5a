"""The package.xml or the build files of the robot's package are invalid.

The package is not built or not found: no file of the robot is installed, and `package://` does not
resolve.

- catkin and colcon stop at an invalid package.xml, or ignore the package: a required element is
  missing, a tag belongs to another format, or the file is not XML. A file with little more than a
  name is assumed to be the stub of a test.
- The project in CMakeLists.txt or setup.py has another name than the package (warning). The build
  installs the files below that name, or catkin stops: "package name does not match project name".
- CMakeLists.txt finds ament_cmake and does not call `ament_package()`, which registers the package,
  or calls it without a `find_package`.
- CMakeLists.txt installs a missing file or directory, and the build fails: "file INSTALL cannot
  find". A clone lacks empty directories, since git stores only files. Not reported in ROS 1:
  catkin's devel space installs nothing.
- CMakeLists.txt finds catkin in a package of type ament_cmake: ROS 2 does not have catkin.
- CMakeLists.txt generates messages, services or actions, also those of a package on which this one
  depends, and the build stops: a file does not exist, package.xml has no `<member_of_group>
  rosidl_interface_packages`, or a package of DEPENDENCIES is not found.
- CMakeLists.txt finds a package of the workspace that package.xml does not declare, so that colcon
  may build it later (warning).
- CMakeLists.txt registers a component under another name than the source, and no container finds
  it: "Failed to find class with the requested plugin name".
- The `<build_type>` needs another build file than the package has: colcon does not build it.
- A package of ROS 2 depends on one that only ROS 1 has, such as rospy, or writes hyphens in the
  name of a ROS package (warning).
- The executables of a Python package of ROS 2 are installed where `ros2 run` does not find them:
  setup.cfg does not set `install_scripts` to `$base/lib/NAME`. Or their module or function does not
  exist (warning).
- The setup.py of a Python package of ROS 2 is not a Python program, or uses a name that it does not
  import, such as `glob`. It names a directory of modules that does not exist; or `find_packages()`
  misses a directory without `__init__.py`, or a pattern for installed files matches none (warning).
  Or a file that it installs does not exist.
- A Python package of ROS 2 is not registered. `ros2 launch`, `package://` and `$(find ...)` find it
  only if setup.py installs an existing file of its name into
  `share/ament_index/resource_index/packages`. If setup.py does not mention that directory, colcon
  creates the file with a deprecation warning; a Debian package lacks it (warning).
  Without `<build_type>ament_python</build_type>` in `<export>`, colcon looks for a CMakeLists.txt.

Only launch files, with the packages of the nodes that they start, and descriptions that refer to
packages are checked.

Sources:
    REP 149, package.xml: https://www.ros.org/reps/rep-0149.html
    catkin_pkg, package.py: https://github.com/ros-infrastructure/catkin_pkg/blob/master/src/catkin_pkg/package.py
    colcon/colcon-ros#79: https://github.com/colcon/colcon-ros/pull/79
    CMake, install(DIRECTORY): https://cmake.org/cmake/help/latest/command/install.html#directory
    ros2/rosidl, rosidl_generate_interfaces.cmake: https://github.com/ros2/rosidl/blob/rolling/rosidl_cmake/cmake/rosidl_generate_interfaces.cmake
    andrewda/learm_ros2#2: https://github.com/andrewda/learm_ros2/issues/2
    ROS 2, developing a package: https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html
"""

import os

from urdfkit.checks.package.build_files import (
    finds_catkin,
    is_ignored,
    missing_directories,
    not_begun,
    not_finished,
    not_registered,
    other_build_type,
    other_name,
    undeclared_packages,
)
from urdfkit.checks.package.component_names import unregistered_components
from urdfkit.checks.package.interfaces import not_generated, packages_with_interfaces
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.ros.catalog import data
from urdfkit.text.document import Element
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source
from urdfkit.text.xml_reader import read_xml
from urdfkit.workspace.install_rules import build_file
from urdfkit.workspace.manifest import REQUIRED, known_tags, nearest_manifest
from urdfkit.workspace.package_references import have_references
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

#: The codes of XML that is not well-formed.
_BROKEN = ("XML001", "XML002")


@rule(Severity.ERROR, help="fix the package.xml")
def check(context: Context) -> Findings:
    path, resolver = context.source.path, context.resolver
    if not (is_launch(path) or have_references(context.document.sources)):
        return
    home = resolver.packages.enclosing(path)
    packages = {home[0]: home[1]} if home else {}
    for name, directory in (packages | _started(context)).items():
        if not is_ignored(directory):
            yield from _of_package(name, directory, resolver)
    for directory in packages_with_interfaces(context) if home and not is_ignored(home[1]) else ():
        yield from not_generated(directory)
        yield from _of_manifest(os.path.join(directory, "package.xml"), resolver)
    file = nearest_manifest(path)
    if file is not None:
        yield from _of_manifest(file, resolver)


def _started(context: Context) -> dict[str, str]:
    """The packages of this workspace whose programs a launch file starts, with directories."""
    started = context.launch.started if is_launch(context.source.path) else ()
    names = sorted({node.package for node in started if not comes_with_ros(node.package)})
    known = context.resolver.packages.known(context.source.path) if names else {}
    return {name: known[name] for name in names if known.get(name)}


def _of_package(name: str, directory: str, resolver: Resolver) -> Findings:
    """Mistakes in the build file of a package."""
    others = list(other_name(name, directory))
    yield from others or not_registered(name, directory)  # which has the name of package.xml
    yield from missing_directories(name, directory)
    yield from finds_catkin(directory)
    yield from not_begun(directory)
    yield from not_finished(directory)
    yield from other_build_type(directory)
    if build_file(directory).endswith(".py"):
        from urdfkit.checks.package.python_executables import not_runnable  # for few robots

        yield from not_runnable(name, directory)
    yield from undeclared_packages(name, directory, resolver)
    yield from unregistered_components(directory, resolver)
    yield from not_generated(directory)


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
