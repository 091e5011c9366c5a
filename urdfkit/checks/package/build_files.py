"""Build files that contradict the package.xml: another name, or no registration with ROS."""

import os
import re

from urdfkit.core import disk
from urdfkit.core.paths import upwards
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Source, Span
from urdfkit.workspace.cmake import blank_cmake_comments
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.install_rules import InstallRules, build_file
from urdfkit.workspace.installs import read_rules
from urdfkit.workspace.manifest import depends_on
from urdfkit.workspace.package_directories import IGNORE_FILES
from urdfkit.workspace.resolve import Resolver

#: Where each build file gives the name, as far as it is written out.
_NAMES = {
    # No part of a name, such as that in front of a variable.
    "CMakeLists.txt": rb"(?im)^[^#\n]*?\bproject\s*\(\s*\"?([A-Za-z][\w-]*)(?![\w$-])",
    "setup.py": rb"(?m)^[ \t]*(?:package_name|PACKAGE_NAME)\s*=\s*[\"']([\w-]+)[\"']",
}
#: Of each build type its build file, and that of the other.
_BUILT_BY = {
    "ament_cmake": ("CMakeLists.txt", "setup.py"),
    "ament_python": ("setup.py", "CMakeLists.txt"),
}
_INDEX = "share/ament_index/resource_index/packages"


def is_ignored(directory: str) -> bool:
    """True for a package that the build skips, as a file in its directory or above it says."""
    for above in upwards(directory):
        if any(disk.exists(os.path.join(above, mark)) for mark in IGNORE_FILES):
            return True
        if disk.exists(os.path.join(above, ".git")):
            break
    return False


def other_name(name: str, directory: str) -> Findings:
    """A build file whose project has another name than the package."""
    file = os.path.basename(build_file(directory))
    source = package_file(directory, file) if file else None
    if source is None:
        return
    # With several projects, such as a superbuild around it, one of them is the package.
    every = list(re.finditer(_NAMES[file], source.data))
    if every and name not in [match.group(1).decode() for match in every]:
        project = every[0]
        yield Finding(
            Span(source, *project.span(1)),
            f"project name '{project.group(1).decode()}' in {file} differs from the package name "
            f"'{name}' in package.xml",
            "use the same name in both files",
            severity=Severity.WARNING,
        )


def not_finished(directory: str) -> Findings:
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


def not_begun(directory: str) -> Findings:
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


def missing_directories(name: str, directory: str) -> Findings:
    """Files and directories that a CMakeLists.txt of ROS 2 installs and that do not exist."""
    source = _build_file_of_ament(directory)
    if source is None:
        return
    text = blank_cmake_comments(source.data)
    is_sure = not re.search(rb"\b(OPTIONAL|EXISTS)\b", text)
    is_ament = re.search(rb"(?m)^\s*find_package\s*\(\s*ament_cmake", text)
    if not (is_ament and is_sure) or InstallRules(directory, name).makes_files:
        return
    for path in dict.fromkeys(rule.source for rule in read_rules(directory, name)):
        place = re.search(rb"(?<=[\s\"/])%s(?=[\s\"/)])" % re.escape(path.encode()), text)
        if place and not _is_filtered(text, place.start()) and is_missing(directory, path):
            yield Finding(
                Span(source, *place.span()),
                f"'{path}' is installed and does not exist: the build of '{name}' fails",
                f"remove it, or create {path}; git keeps no empty directory",
                group_key="not there",
            )


def _is_filtered(text: bytes, place: int) -> bool:
    """True inside of a command with FILES_MATCHING, which needs no directory."""
    return b"FILES_MATCHING" in text[place:].partition(b")")[0]


def is_missing(directory: str, path: str) -> bool:
    """True if a file of a package does not exist, and is not one that the build creates."""
    whole = os.path.normpath(os.path.join(directory, path))
    if not whole.startswith(os.path.join(directory, "")) or disk.exists(whole):
        return False
    from urdfkit.workspace.gitignore import is_ignored  # which runs git

    return not is_ignored(whole)


def finds_catkin(directory: str) -> Findings:
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


def other_build_type(directory: str) -> Findings:
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
    has = {file: disk.exists(os.path.join(directory, file)) for file in _NAMES}
    if needed and not has[needed] and has[other]:
        yield Finding(
            Span(manifest, *match.span(1)),
            f"build type {kind} needs a {needed}, and the package has a {other}",
            "write " + next(command for command, (file, _) in _BUILT_BY.items() if file == other),
        )


def undeclared_packages(name: str, directory: str, resolver: Resolver) -> Findings:
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


def not_registered(name: str, directory: str) -> Findings:
    """A Python package of ROS 2 that ROS or colcon does not find."""
    if build_file(directory).endswith(".txt"):
        return
    manifest, setup = (package_file(directory, file) for file in ("package.xml", "setup.py"))
    if manifest is None or setup is None:
        return
    named = re.search(rb"<build_type\b[^<>]*>\s*(\w*)", manifest.data)
    if named and named.group(1) == b"ament_python":
        yield from _unregistered(setup, directory, name)
    elif not named and _INDEX.encode() in setup.data:
        message = "no build type: colcon looks for a CMakeLists.txt"
        help = "add <export><build_type>ament_python</build_type></export>"
        yield Finding(Span(manifest, 0, 0), message, help)


def _build_file_of_ament(directory: str) -> Source | None:
    """The CMakeLists.txt that builds a package, if it mentions ament_cmake."""
    source = (
        package_file(directory, "CMakeLists.txt")
        if build_file(directory).endswith(".txt")
        else None
    )
    return source if source and b"ament_cmake" in source.data else None


def package_file(directory: str, file: str) -> Source | None:
    """A file of a package; None if it is missing, or not a regular file."""
    path = os.path.join(directory, file)
    data = read_head(path)
    return Source(path, data) if data else None


def _unregistered(setup: Source, directory: str, name: str) -> Findings:
    if b"resource_index" not in setup.data:
        message = (
            f"nothing is installed into {_INDEX}: ROS finds the package '{name}' only where colcon "
            "adds the entry, with a warning"
        )
        help = f"add ('{_INDEX}', ['resource/{name}']) to data_files, and create that empty file"
        yield Finding(Span(setup, 0, 0), message, help, severity=Severity.WARNING)
        return
    marker = re.search(rb"[\"']resource/|[\"']resource[\"']\s*,", setup.data)
    if marker and not disk.exists(os.path.join(directory, "resource", name)):
        message = f"file not found: resource/{name}, which setup.py installs"
        yield Finding(Span(setup, *marker.span()), message, "create it; it may be empty")
