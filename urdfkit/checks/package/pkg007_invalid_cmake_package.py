"""CMakeLists.txt does not build the robot's package, or installs it where ROS does not find it.

- The project has another name than the package (warning). The build installs the files below that
  name, or catkin stops: "package name does not match project name".
- It finds ament_cmake and does not call `ament_package()`, which registers the package,
  or calls it without a `find_package`.
- It installs a missing file or directory, and the build fails: "file INSTALL cannot
  find". A clone lacks empty directories, since git stores only files. Not reported in ROS 1:
  catkin's devel space installs nothing.
- It finds catkin in a package of type ament_cmake: ROS 2 does not have catkin.
- It finds a package of the workspace that package.xml does not declare, so that colcon
  may build it later (warning).
- An environment hook adds a directory of the package to a variable that it does not have (warning).
- It registers a component under another name than the source, and no container finds
  it: "Failed to find class with the requested plugin name".

Only launch files, with the packages of the nodes that they start, and descriptions that refer to
packages are checked.

Sources:
    CMake, install(DIRECTORY): https://cmake.org/cmake/help/latest/command/install.html#directory
    ROS 2, developing a package: https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html
    andrewda/learm_ros2#2: https://github.com/andrewda/learm_ros2/issues/2
"""

import re
from itertools import islice

from urdfkit.checks.package.build_files import (
    is_missing,
    other_name,
    package_file,
    packages_to_build,
)
from urdfkit.checks.package.component_names import unregistered_components
from urdfkit.checks.package.samples import robot_of_package
from urdfkit.lint.rules import Context, Finding, Findings, Severity, rule
from urdfkit.mesh.samples import PLATE
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source, Span
from urdfkit.workspace.cmake import blank_cmake_comments
from urdfkit.workspace.install_rules import InstallRules, build_file
from urdfkit.workspace.installs import read_rules
from urdfkit.workspace.manifest import depends_on
from urdfkit.workspace.resolve import Resolver

NAME = "urdf/bot.urdf"
BAD = robot_of_package("bot_description")
GOOD = BAD.replace("package://bot_description", "..")
FILES = {
    "package.xml": b"<package><name>bot_description</name></package>",
    "CMakeLists.txt": b"project(bot_description)\nfind_package(ament_cmake REQUIRED)\n",
    "meshes/base.stl": PLATE,
}

#: The beginning of a command that installs, and so many bytes are read before a path in it, at so
#: many places that name the path.
_INSTALL = re.compile(rb"(?i)\binstall\s*\([^()]*\Z")
_MAX_BEFORE, _MAX_PLACES = 2000, 100


@rule(Severity.ERROR, help="fix the CMakeLists.txt")
def check(context: Context) -> Findings:
    for name, directory in packages_to_build(context).items():
        if build_file(directory).endswith(".txt"):
            yield from other_name(name, directory)
        yield from _missing_directories(name, directory)
        yield from _missing_in_hooks(name, directory)
        yield from _finds_catkin(directory)
        yield from _not_begun(directory)
        yield from _not_finished(directory)
        yield from _undeclared_packages(name, directory, context.resolver)
        yield from unregistered_components(directory, context.resolver)


def _missing_directories(name: str, directory: str) -> Findings:
    """Files and directories that a CMakeLists.txt of ROS 2 installs and that do not exist."""
    source = _build_file_of_ament(directory)
    if source is None:
        return
    text = blank_cmake_comments(source.data)
    is_sure = not re.search(rb"\b(OPTIONAL|EXISTS)\b", text)
    is_ament = re.search(rb"(?m)^\s*find_package\s*\(\s*ament_cmake", text)
    if not (is_ament and is_sure) or InstallRules(directory, name).makes_files:
        return
    for path in dict.fromkeys(install.source for install in read_rules(directory, name)):
        place = _place_of(path, text)
        if place and not _is_filtered(text, place.start()) and is_missing(directory, path):
            yield Finding(
                Span(source, *place.span()),
                f"'{path}' is installed and does not exist: the build of '{name}' fails",
                f"remove it, or create {path}; git keeps no empty directory",
            )


def _missing_in_hooks(name: str, directory: str) -> Findings:
    """Directories below ``share`` that hooks add to a variable, and that nothing installs."""
    build = package_file(directory, "CMakeLists.txt")
    if build is None or b"environment_hooks" not in build.data.lower():
        return
    from urdfkit.workspace.environment_hooks import hook_entries  # for few packages

    share = f"share/{name}/"
    for entry in hook_entries(name, directory):
        path = entry.path.removeprefix(share)
        last = re.escape(path.rpartition("/")[2].encode())
        if path == entry.path or re.search(rb"\b%s\b" % last, build.data):
            continue  # it may be installed below another name
        if is_missing(directory, path):
            yield Finding(
                entry.span,
                f"'{name}' has no directory '{path}', which is added to {entry.variable}",
                "fix the path, or create and install the directory",
                severity=Severity.WARNING,
            )


def _place_of(path: str, text: bytes) -> re.Match[bytes] | None:
    """Where a path is installed, or else the first place that names it, as in a variable."""
    name = rb"(?<=[\s\"/])%s(?=[\s\"/)])" % re.escape(path.encode())
    installing = (
        place
        for place in islice(re.finditer(name, text), _MAX_PLACES)
        if _INSTALL.search(text[max(0, place.start() - _MAX_BEFORE) : place.start()])
    )
    return next(installing, None) or re.search(name, text)


def _is_filtered(text: bytes, place: int) -> bool:
    """True inside of a command with FILES_MATCHING, which needs no directory."""
    return b"FILES_MATCHING" in text[place:].partition(b")")[0]


def _finds_catkin(directory: str) -> Findings:
    """A package of type ament_cmake with a CMakeLists.txt for ROS 1."""
    manifest, source = (package_file(directory, file) for file in ("package.xml", "CMakeLists.txt"))
    if manifest is None or source is None or b"ament_cmake" not in manifest.data:
        return
    kinds = re.findall(rb"<build_type\b([^<>]*)>\s*(\w+)", blank_comments(manifest.data))
    match = re.search(rb"(?m)^[ \t]*find_package\s*\(\s*(catkin)\b", source.data)
    has_other = re.search(rb"(?m)^[ \t]*find_package\s*\(\s*ament_cmake|ROS_VERSION", source.data)
    if kinds == [(b"", b"ament_cmake")] and match and not has_other:
        yield Finding(
            Span(source, *match.span(1)),
            "CMakeLists.txt finds catkin, and package.xml has build type ament_cmake: ROS 2 has "
            "no catkin",
            "write find_package(ament_cmake REQUIRED), and ament_package() as the last line",
        )


def _not_begun(directory: str) -> Findings:
    """A CMakeLists.txt that calls ament_package() and finds no package that could define it."""
    is_built = build_file(directory).endswith(".txt")
    source = package_file(directory, "CMakeLists.txt") if is_built else None
    text = blank_cmake_comments(source.data) if source else b""
    match = re.search(rb"\b(ament_package)\s*\(", text)
    if source and match and not re.search(rb"\b(find_package|include|add_subdirectory)\b", text):
        yield Finding(
            Span(source, *match.span(1)),
            "ament_package() is unknown: the build fails",
            "write find_package(ament_cmake REQUIRED) above",
        )


def _not_finished(directory: str) -> Findings:
    """A CMakeLists.txt that does not end in ament_package(): ROS does not find the package."""
    source = _build_file_of_ament(directory)
    if source is None:
        return
    text = blank_cmake_comments(source.data)
    match = re.search(rb"(?m)^\s*find_package\s*\(\s*(ament_cmake)\b", source.data)
    if match and not re.search(rb"ament\w*_package\s*\(|\b(include|macro)\s*\(", text):
        yield Finding(
            Span(source, *match.span(1)),
            "ament_package() is not called: ROS does not find the package after the build",
            "write ament_package() as the last line",
        )


def _undeclared_packages(name: str, directory: str, resolver: Resolver) -> Findings:
    """Packages of the workspace that CMake looks for, and that colcon need not build before."""
    source = _build_file_of_ament(directory)
    if source is None:
        return
    text = blank_cmake_comments(source.data)
    known = resolver.packages.known(source.path)
    for match in re.finditer(rb"(?m)^find_package\s*\(\s*([\w-]+)\s+REQUIRED", text):
        other = match[1].decode()
        if other in known and other != name and not depends_on(name, other, source.path, resolver):
            message = f"CMakeLists.txt finds {other}, which package.xml does not declare: colcon "
            message += "may build it later"
            help = f"add <depend>{other}</depend> to package.xml"
            yield Finding(Span(source, *match.span(1)), message, help, severity=Severity.WARNING)


def _build_file_of_ament(directory: str) -> Source | None:
    """The CMakeLists.txt that builds a package, if it mentions ament_cmake."""
    source = (
        package_file(directory, "CMakeLists.txt")
        if build_file(directory).endswith(".txt")
        else None
    )
    return source if source and b"ament_cmake" in source.data else None
