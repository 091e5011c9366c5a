"""The arguments that the launch files of a package pass to one of its robots."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.errors import PackageNotFound
from urdfkit.ros.launch import read_launch
from urdfkit.text.document import CallFrame, Element
from urdfkit.text.source import Source
from urdfkit.workspace.launch_files import directories_of_launch_files, launch_files
from urdfkit.workspace.ownership import is_generated
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.ros.launch.contents import FileUse, Launch

#: A launch file that loads YAML, or includes one that does, contains one of these words.
_LOADING = (b"yaml", b"yml", b"include", b"moveit")
#: In a configuration of MoveIt Pro, the package whose configuration it extends.
_BASE = rb"(?m)^based_on_package:\s*['\"]?([\w-]+)"


class RobotArguments(Record):
    """Arguments of a robot."""

    arguments: dict[str, str]  # for xacro
    launch: str  # path of the launch file
    frame: CallFrame | None  # its location; None if it passes them to another robot
    unknown: tuple[str, ...] = ()  # those known only at run time; "" stands for any name
    parameters: tuple[FileUse, ...] = ()  # parameter files that it loads for the robot

    @property
    def is_whole(self) -> bool:
        """False if some arguments are known only at run time."""
        return not self.unknown


def started_robots(launch: Launch, path: str) -> Iterator[tuple[str, RobotArguments]]:
    """The robots that a launch file starts: paths and arguments.

    Args:
        path: of the launch file.
    """
    # With several robots, it is unknown which of them the parameters are for.
    is_single = len({robot.path for robot in launch.descriptions}) == 1
    parameters = launch.parameters if is_single else ()
    for robot in launch.descriptions:
        arguments = RobotArguments(robot.arguments, path, robot.frame, robot.unknown, parameters)
        yield robot.path, arguments
    for robot, file in launch.built if not launch.descriptions else ():
        files = (file,) if file else launch.parameters if len(launch.built) == 1 else ()
        arguments = RobotArguments(robot.arguments, path, robot.frame, robot.unknown, files)
        yield robot.path, arguments


def passed_arguments(
    robot: str,
    needed: Collection[str],
    resolver: Resolver,
    *,
    only_parameters: bool = False,
    wanted: Collection[str] = (),
) -> list[RobotArguments]:
    """Arguments from launch files for a robot: of its package, then others of the workspace.

    If no launch file starts a robot that lacks arguments, the needed arguments that they pass to
    other robots of the package are used: an argument of a launch file may choose the robot.

    Args:
        needed: names of the arguments that the robot lacks.
        only_parameters: True if the arguments do not matter, as the robot declares none: launch
            files that load no parameter file are then not read.
        wanted: names of further arguments, which are taken from other robots if they get them.
    """
    real = disk.real(robot)
    own: list[RobotArguments] = []
    of_siblings: list[RobotArguments] = []
    package = resolver.packages.enclosing(robot)
    for directory, name in directories_of_launch_files(robot, resolver):
        for path, passed in _started(directory, name, resolver, only_parameters=only_parameters):
            if not passed.arguments.keys() >= set(needed):
                continue
            if disk.real(path) == real:
                own.append(passed)
            elif needed and resolver.packages.enclosing(path) == package:
                names = passed.arguments.keys() & {*needed, *wanted}
                chosen = {name: passed.arguments[name] for name in sorted(names)}
                of_siblings.append(RobotArguments(chosen, passed.launch, None))
    return own or of_siblings


def known_at_run_time(robot: str, names: Collection[str], resolver: Resolver) -> tuple[str, ...]:
    """The arguments whose value is known only at run time in all launch files that pass them.

    Empty if all arguments of a launch file that starts the robot are known, or if there is none.
    """
    real = disk.real(robot)
    for directory, mentioned in directories_of_launch_files(robot, resolver):
        robots = _started(directory, mentioned, resolver)
        launches = [arguments for path, arguments in robots if disk.real(path) == real]
        if launches:
            known = {name for launch in launches for name in launch.arguments}
            unknown = {name for launch in launches for name in launch.unknown}
            if any(launch.is_whole for launch in launches):
                return ()
            passed = names if "" in unknown else unknown.intersection(names)
            return tuple(sorted(set(passed) - known))
    return ()


def is_handed_on(robot: str, argument: str, resolver: Resolver) -> bool:
    """True if a launch file names a robot and a value of an argument, but not to xacro.

    A function of the workspace may take both: ``get_xacro_file_content(path, {'dof': dof})``.
    """
    real, word = disk.real(robot), re.escape(argument.encode())
    named = re.compile(rb"(?<![\w.-])%b\b" % re.escape(os.path.basename(robot).encode()))
    given = re.compile(rb"\b%b:=|(['\"])%b\1\s*:" % (word, word))
    return any(
        named.search(source.data)
        and given.search(source.data)
        and all(
            disk.real(description.path) != real
            for description in read_launch(source, resolver).descriptions
        )
        for directory, mentioned in directories_of_launch_files(robot, resolver)
        for source in launch_files(directory, mentioned, resolver)
    )


def is_in_moveit_pro(robot: str, argument: str, resolver: Resolver) -> bool:
    """True if MoveIt Pro passes an argument to a robot that its package configures.

    It passes the ``urdf_params`` of ``config/config.yaml``, and of the package that this is based
    on: https://github.com/PickNikRobotics/moveit_pro_example_ws
    """
    package = resolver.packages.enclosing(robot)
    config = _moveit_pro_config(package[1], resolver) if package else None
    if not config or os.path.basename(robot).encode() not in config.data:
        return False
    given = re.compile(rb"(?m)^\s*-\s+%b:" % re.escape(argument.encode()))
    if given.search(config.data):
        return True
    try:
        match = re.search(_BASE, config.data)
        base = resolver.package(match[1].decode() if match else "", config.path)
    except PackageNotFound:
        return False
    config = _moveit_pro_config(base, resolver)
    return bool(config and given.search(config.data))


def _moveit_pro_config(package: str, resolver: Resolver) -> Source | None:
    source = resolver.readable(os.path.join(package, "config", "config.yaml"))
    return source if source and b"robot_description:" in source.data else None


def declared(robot: str, resolver: Resolver) -> Iterator[tuple[str, dict[str, list[str]]]]:
    """The values that launch files about the package of a robot declare for their own arguments.

    Yields:
        The path of a launch file, and the choices or the default of each of its arguments.
    """
    for directory, name in directories_of_launch_files(robot, resolver):
        yield from _declarations(directory, name, resolver)


def launches_of_workspace(path: str, resolver: Resolver) -> tuple[Launch, ...]:
    """The contents of all launch files in the workspace of a file."""
    return launches_below(resolver.packages.workspace(path), resolver)


def launches_of_package(path: str, resolver: Resolver) -> tuple[Launch, ...]:
    """The contents of all launch files in the package of a file; in a large workspace some lack."""
    package = resolver.packages.enclosing(path)
    return launches_below(package[1], resolver) if package else ()


def is_passed_to_xacro(source: Source, resolver: Resolver) -> bool:
    """True for a file that a launch file of its workspace expands with xacro."""
    real, launches = disk.real(source.path), launches_of_workspace(source.path, resolver)
    robots = (robot for launch in launches for robot in launch.descriptions)
    return any(robot.is_expanded and disk.real(robot.path) == real for robot in robots)


def is_not_started(source: Source, resolver: Resolver) -> bool:
    """True for a URDF that no launch file of its workspace references.

    The file must be generated, or another robot of its package must be started: otherwise the
    launch files may compute its name at run time.
    """
    directory, name = resolver.packages.workspace(source.path), os.path.basename(source.path)
    if not name.endswith(".urdf"):
        return False
    named = re.compile(rb"\b%b(?!\.xacro)" % re.escape(name.encode()))
    if any(named.search(launch.data) for launch in launch_files(directory, name, resolver)):
        return False
    package = resolver.packages.enclosing(source.path)
    launches = launches_of_workspace(source.path, resolver) if package else ()
    paths = {robot.path for launch in launches for robot in launch.descriptions}
    return is_generated(source) or any(resolver.packages.enclosing(p) == package for p in paths)


@lru_cache(maxsize=2)  # the launch files of a workspace are queried one after the other
def launches_below(directory: str, resolver: Resolver) -> tuple[Launch, ...]:
    """The contents of all launch files below a directory."""
    return tuple(read_launch(source, resolver) for source in launch_files(directory, "", resolver))


@lru_cache(maxsize=4)  # the robots of a package, and their SRDFs, are queried in turn
def _started(
    directory: str, mentioned: str, resolver: Resolver, *, only_parameters: bool = False
) -> tuple[tuple[str, RobotArguments], ...]:
    """The robots that the launch files of a directory start."""
    return tuple(
        robot
        for source in launch_files(directory, mentioned, resolver)
        if not only_parameters or any(word in source.data.lower() for word in _LOADING)
        for choice in _choices(source)
        for robot in started_robots(read_launch(source, resolver, choice), source.path)
    )


@lru_cache(maxsize=2)
def _declarations(
    directory: str, mentioned: str, resolver: Resolver
) -> tuple[tuple[str, dict[str, list[str]]], ...]:
    return tuple(
        (source.path, _declared(source, with_defaults=True))
        for source in launch_files(directory, mentioned, resolver)
    )


def _choices(source: Source) -> Iterator[dict[str, str]]:
    """Ways to start a launch file.

    Each choice of an argument without a default is used; other arguments have their first choice.
    """
    choices = _declared(source, with_defaults=False)
    first = {name: values[0] for name, values in choices.items()}
    yield first
    for name, values in choices.items():
        for value in values[1:]:
            yield first | {name: value}


class _Argument(Record):
    """An argument that a launch file declares."""

    name: str  # empty if known only at run time
    choices: tuple[str, ...]  # empty texts are known only at run time
    default: str | None  # None if it is missing, or known only at run time
    is_required: bool  # True if it has no default


def _declared(source: Source, *, with_defaults: bool) -> dict[str, list[str]]:
    """The choices of the arguments of a launch file.

    Args:
        with_defaults: also those of arguments with a default, and defaults without choices.
    """
    values_by_name: dict[str, list[str]] = {}
    for argument in _of_python(source) if source.path.endswith(".py") else _of_xml(source):
        values = [choice for choice in argument.choices if choice]
        if with_defaults and not values and argument.default is not None:
            values = [argument.default]
        if argument.name and values and (with_defaults or argument.is_required):
            values_by_name[argument.name] = values
    return values_by_name


def _of_python(source: Source) -> Iterator[_Argument]:
    import ast

    from urdfkit.ros.launch.calls import argument, called
    from urdfkit.text import python_source

    try:
        tree = python_source.parse(source.data)
    except SyntaxError:
        return  # reported by the check of the file itself
    for call in python_source.nodes(tree):
        if isinstance(call, ast.Call) and called(call) == "DeclareLaunchArgument":
            choices, default = argument(call, None, "choices"), argument(call, 1, "default_value")
            listed = choices.elts if isinstance(choices, (ast.List, ast.Tuple)) else ()
            yield _Argument(
                python_source.string(argument(call, 0, "name")) or "",
                tuple(python_source.string(choice) or "" for choice in listed),
                python_source.string(default),
                default is None,
            )


def _of_xml(source: Source) -> Iterator[_Argument]:
    from urdfkit.ros.launch.markup import parsed
    from urdfkit.ros.launch.signature import arguments_in

    document, _ = parsed(source)
    declared: Iterator[Element] = arguments_in(document.root) if document else iter(())
    for element in declared:
        default = element.get("default") or element.get("value")
        yield _Argument(
            element.get("name") or "",
            tuple(child.get("value") or "" for child in element.children if child.tag == "choice"),
            None if default is None or "$" in default else default,
            default is None,
        )
