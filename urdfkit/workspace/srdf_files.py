"""Search for the SRDF files of a robot, such as in its MoveIt package."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.workspace.file_head import head_text, read_head
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.resolve import Resolver

_SRDF, _ROBOT = (".srdf", ".srdf.xacro"), (".urdf", ".xacro")
#: The root of a robot; the root of a part has no name.
_NAMED = rb"<robot\b[^<>]*\bname\s*="
_ROBOT_NAME = r"<robot\b[^<>]*\bname\s*=\s*[\"']([^\"'$]+)[\"']"
#: A section of ``.setup_assistant`` with its content; compiled when needed, which is rare.
_SECTION = r"(?mi)^([ \t]*){}:[ \t]*\n((?:\1[ \t]+\S.*\n?)+)"
_ENTRY = r"(?m)^[ \t]*{}:\s*\"?([^\s\"]+)"
_ARGUMENTS = r"(?m)^[ \t]*xacro_args:[ \t]*[\"']?([^\"'\n]*)"


def srdf_files(robot: str, resolver: Resolver) -> list[str]:
    """The SRDF files that may be for a robot.

    The robot's directory, a sibling directory ``srdf``, ``config`` and ``srdf`` of its package, and
    sibling MoveIt packages whose ``.setup_assistant`` refers to the robot's file are searched.
    """
    directory = os.path.dirname(os.path.abspath(robot))
    package = resolver.packages.enclosing(robot)
    if _is_for_tests(robot, package):
        return list(srdf_in([directory], resolver))
    top = package[1] if package else directory
    directories = dict.fromkeys(
        (directory, *(os.path.join(top, name) for name in ("config", "srdf")))
    )
    parent = os.path.dirname(directory)
    if resolver.packages.searches(parent, robot):
        directories[os.path.join(parent, "srdf")] = None
    for moveit in _moveit_packages(robot, resolver):
        setup = setup_assistant(moveit)
        if package and setup.is_for(robot, package) and not setup.has_arguments:
            directories.update(dict.fromkeys(_directories(moveit, setup)))
    return list(srdf_in(directories, resolver))


def has_srdf_files(robot: str, name: str, resolver: Resolver) -> bool:
    """True if there are SRDF files in the package of a robot, or elsewhere that may be for it."""
    return bool(srdf_files(robot, resolver) or other_srdf_files(robot, name, resolver))


def other_srdf_files(robot: str, name: str, resolver: Resolver) -> list[str]:
    """The SRDF files of sibling MoveIt packages that may be for a robot, or for another one.

    Their packages expand the robot with arguments, do not state for which file they are, or have
    the SRDF in a directory of ``config`` now. A package for several robots may have one for each.

    Args:
        name: of the robot; an SRDF belongs to the robot with its name, or to the robot with which a
            launch file of MoveIt starts it.
    """
    package = resolver.packages.enclosing(robot)
    if _is_for_tests(robot, package):
        return []
    directories: dict[str, None] = {}
    for moveit in _moveit_packages(robot, resolver):
        setup = setup_assistant(moveit)
        is_for = package is not None and setup.is_for(robot, package)
        is_stale = _is_renamed(setup, moveit, robot, resolver) or _includes(robot, setup)
        is_moved = is_for and not any(srdf_in(_directories(moveit, setup), resolver))
        if not setup.urdf or is_stale or is_moved or (is_for and setup.has_arguments):
            for directory in _directories(moveit, setup):
                directories.update(dict.fromkeys((directory, *_inner(directory, resolver))))
    files = list(srdf_in(directories, resolver))
    return [path for path in files if _may_have_name(path, name)] or [
        path for path in files if _is_started_with(path, robot, resolver)
    ]


def _is_renamed(setup: SetupAssistant, moveit: str, robot: str, resolver: Resolver) -> bool:
    """True if the package of the robot was renamed since the assistant ran.

    One that launch files still name is not in the workspace; its robot may be another one.
    """
    if setup.package in resolver.packages.known(robot):
        return False
    return not setup.package or not any(launch_files(moveit, setup.package, resolver))


def _includes(robot: str, setup: SetupAssistant) -> bool:
    """True if a robot names the file that the assistant read, and so extends it."""
    file = os.path.basename(setup.urdf)
    return os.path.basename(robot) != file and file.encode() in read_head(robot, 100_000)


def are_for(package: str, robot: str, resolver: Resolver) -> bool:
    """True if the SRDFs of a package may be for a robot of any package, by what they name."""
    setup, own = setup_assistant(package), resolver.packages.enclosing(robot)
    if own is not None and setup.is_for(robot, own):
        return True
    files = srdf_in(dict.fromkeys(_directories(package, setup)), resolver)
    heads = (head_text(file, 20_000) for file in files)
    names = (match.group(1) for match in map(re.compile(_ROBOT_NAME).search, heads) if match)
    return any(has_robot_name(robot, name) for name in names)


def is_of_namesake(srdf: str, robot: str, resolver: Resolver) -> bool:
    """True if an SRDF has the name of another robot's file in the same directory.

    A file that the robot refers to is a part of it, not another robot.
    """
    own, directory = os.path.basename(robot), os.path.dirname(os.path.abspath(robot))
    stem = os.path.basename(srdf).partition(".")[0]
    if os.path.dirname(srdf) != directory or own.partition(".")[0] == stem:
        return False
    for name in resolver.directories.entries(directory) or ():
        if name.startswith(f"{stem}.") and name.endswith(_ROBOT) and not name.endswith(_SRDF):
            is_part = name.encode() in read_head(robot, 100_000)
            if not is_part and re.search(_NAMED, read_head(os.path.join(directory, name), 20_000)):
                return True
    return False


def has_robot_name(path: str, name: str) -> bool:
    """True for the file of a robot with this name."""
    if not path.endswith(_ROBOT) or path.endswith(_SRDF):
        return False
    named = rb"%b[\"']%b[\"']" % (_NAMED, re.escape(name.encode()))
    return re.search(named, read_head(path, 20_000)) is not None


def _is_started_with(srdf: str, robot: str, resolver: Resolver) -> bool:
    """True if a launch file in the package of an SRDF passes it with the robot to MoveIt."""
    directory = os.path.join(os.path.dirname(os.path.dirname(srdf)), "launch")
    for name in resolver.directories.entries(directory) or ():
        if name.endswith(".launch.py"):
            text = head_text(os.path.join(directory, name), 100_000)
            files = (os.path.basename(srdf), os.path.basename(robot))
            if all(re.search(rf"(?<![\w.-]){re.escape(file)}", text) for file in files):
                return True
    return False


def _is_for_tests(robot: str, package: tuple[str, str] | None) -> bool:
    """True for a robot in a test directory of a package, which may be wrong intentionally."""
    if package is None:
        return False
    inside = os.path.relpath(os.path.abspath(robot), package[1])
    return not {"test", "tests"}.isdisjoint(inside.split(os.sep))


def _may_have_name(srdf: str, name: str) -> bool:
    """True if the robot of an SRDF has a name, or its name is an expression."""
    text = head_text(srdf, 20_000)
    head = text.partition("<robot")[2].partition(">")[0]
    return head.replace("'", '"').partition('name="')[2].startswith((f'{name}"', "$"))


def srdf_in(directories: Iterable[str], resolver: Resolver) -> Iterator[str]:
    """The SRDF files in directories."""
    for directory in directories:
        for name in sorted(resolver.directories.entries(directory) or ()):
            if name.endswith(_SRDF):
                yield os.path.join(directory, name)


def _moveit_packages(robot: str, resolver: Resolver) -> Iterator[str]:
    """The MoveIt packages next to a robot's package, also inside a directory of such packages.

    Elsewhere in the workspace, those whose assistant read this robot.
    """
    package = resolver.packages.enclosing(robot)
    parent = os.path.dirname(package[1]) if package else ""
    if package is None or not resolver.packages.searches(parent, robot):
        return  # the parent is outside of the repository
    near = [package[1]]
    for name in resolver.directories.entries(parent) or ():
        directory = os.path.join(parent, name)
        if "moveit" not in name or directory == package[1]:
            continue
        entries = resolver.directories.entries(directory) or {}
        if "package.xml" in entries:
            near.append(directory)
        else:
            near += [os.path.join(directory, inner) for inner in entries if "moveit" in inner]
    yield from near[1:]
    for directory in resolver.packages.known(robot).values():
        is_elsewhere = "moveit" in os.path.basename(directory) and directory not in near
        if is_elsewhere and setup_assistant(directory).is_for(robot, package):
            yield directory


class SetupAssistant(Record):
    """Contents of MoveIt's ``.setup_assistant``; all empty if it is missing."""

    package: str = ""  # of the robot's file
    urdf: str = ""  # path of the robot's file in its package
    srdf: str = ""  # path of the SRDF in the MoveIt package
    has_arguments: bool = False  # True if the robot is expanded with arguments
    arguments: Mapping[str, str] = {}  # these arguments

    def is_for(self, robot: str, package: tuple[str, str]) -> bool:
        """True if it refers to a robot file of a package, or to the URDF made of a xacro."""
        if not self.urdf or self.package != package[0]:
            return False
        path, own = os.path.normpath(os.path.join(package[1], self.urdf)), os.path.abspath(robot)
        return path in (own, own.removesuffix(".xacro"))


def setup_assistant(directory: str) -> SetupAssistant:
    """The settings of a MoveIt package."""
    text = head_text(os.path.join(directory, ".setup_assistant"), 100_000).replace("\r\n", "\n")

    def section(name: str) -> str:
        match = re.search(_SECTION.format(name), text)
        return match.group(2) if match else ""

    def entry(text: str, name: str) -> str:
        match = re.search(_ENTRY.format(name), text)
        return match.group(1) if match else ""

    urdf, srdf = section("urdf"), entry(section("srdf"), "relative_path")
    match = re.search(_ARGUMENTS, urdf)
    pairs = (word.partition(":=") for word in match.group(1).split()) if match else ()
    return SetupAssistant(
        entry(urdf, "package"),
        entry(urdf, "relative_path"),
        srdf,
        ":=" in urdf,
        {name: value for name, mark, value in pairs if mark},
    )


def _inner(directory: str, resolver: Resolver) -> Iterator[str]:
    """The directories in a directory."""
    for name, is_directory in (resolver.directories.entries(directory) or {}).items():
        if is_directory:
            yield os.path.join(directory, name)


def _directories(moveit: str, setup: SetupAssistant) -> Iterator[str]:
    """The directories of a MoveIt package that may contain its SRDF."""
    yield from (os.path.join(moveit, name) for name in ("config", "srdf"))
    if setup.srdf:
        yield os.path.normpath(os.path.join(moveit, os.path.dirname(setup.srdf)))
