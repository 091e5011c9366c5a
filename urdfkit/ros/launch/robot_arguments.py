"""The arguments that the launch files of a package pass to one of its robots."""

from __future__ import annotations

import os
import re
from collections.abc import Collection, Iterator
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.ros.launch import read_launch
from urdfkit.text.document import CallFrame, Element
from urdfkit.text.source import Source
from urdfkit.workspace.launch_files import directories_of_launch_files, launch_files
from urdfkit.workspace.ownership import is_generated
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.ros.launch.contents import FileUse, Launch

#: A launch file that loads YAML, or includes one that does, contains one of these words.
_LOADING = re.compile(rb"(?i)yaml|yml|include|moveit")


class RobotArguments(Record):
    """Arguments of a robot."""

    arguments: dict[str, str]  # for xacro
    launch: str  # path of the launch file
    frame: CallFrame | None  # its place; None if it passes them to another robot
    is_whole: bool = True  # False if there are others that are known only at run time
    parameters: tuple[FileUse, ...] = ()  # parameter files that it loads for the robot


def started(launch: Launch, path: str) -> Iterator[tuple[str, RobotArguments]]:
    """The robots that a launch file starts: paths and arguments.

    Args:
        path: of the launch file.
    """
    # With several robots, it is unknown which of them the parameters are for.
    is_one = len({one.path for one in launch.descriptions}) == 1
    parameters = launch.parameters if is_one else ()
    for one in launch.descriptions:
        yield one.path, RobotArguments(one.arguments, path, one.frame, one.is_whole, parameters)


def given(
    robot: str, needed: Collection[str], resolver: Resolver, *, only_parameters: bool = False
) -> list[RobotArguments]:
    """Arguments from launch files for a robot: of its package, then others of the workspace.

    If no launch file starts a robot that lacks arguments, the needed arguments that they pass to
    other robots of the package are used: an argument of a launch file may choose the robot.

    Args:
        needed: names of the arguments that the robot lacks.
        only_parameters: True if the arguments do not matter, as the robot declares none: launch
            files that load no parameter file are then not read.
    """
    real = disk.real(robot)
    own: list[RobotArguments] = []
    others: list[RobotArguments] = []
    package = resolver.packages.enclosing(robot)
    for directory, name in directories_of_launch_files(robot, resolver):
        for path, one in _started(directory, name, resolver, only_parameters=only_parameters):
            if not one.arguments.keys() >= set(needed):
                continue
            if disk.real(path) == real:
                own.append(one)
            elif needed and resolver.packages.enclosing(path) == package:
                chosen = {name: one.arguments[name] for name in needed}
                others.append(RobotArguments(chosen, one.launch, None))
    return own or others


def known_at_run_time(robot: str, names: Collection[str], resolver: Resolver) -> tuple[str, ...]:
    """Those of some arguments to which each launch file that starts a robot gives unknown values.

    That is what they may be: a launch file that the values of others come from is not read. Empty
    if no launch file starts the robot.
    """
    real = disk.real(robot)
    for directory, mentioned in directories_of_launch_files(robot, resolver):
        found = [
            one for path, one in _started(directory, mentioned, resolver) if disk.real(path) == real
        ]
        if found:
            is_open = not any(one.is_whole for one in found)
            known = {name for one in found for name in one.arguments}
            return tuple(sorted(set(names) - known)) if is_open else ()
    return ()


def declared(robot: str, resolver: Resolver) -> Iterator[tuple[str, dict[str, list[str]]]]:
    """The values that launch files about the package of a robot declare for their own arguments.

    Yields:
        The path of a launch file, and the choices or the default of each of its arguments.
    """
    for directory, name in directories_of_launch_files(robot, resolver):
        yield from _declarations(directory, name, resolver)


def launches_of_workspace(path: str, resolver: Resolver) -> tuple[Launch, ...]:
    """The contents of all launch files in the workspace of a file."""
    return _launches(resolver.packages.workspace(path), resolver)


def is_passed_to_xacro(source: Source, resolver: Resolver) -> bool:
    """True for a file that a launch file of its workspace expands with xacro."""
    real, launches = disk.real(source.path), launches_of_workspace(source.path, resolver)
    described = (one for launch in launches for one in launch.descriptions)
    return any(one.is_expanded and disk.real(one.path) == real for one in described)


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
    paths = {one.path for launch in launches for one in launch.descriptions}
    return is_generated(source) or any(resolver.packages.enclosing(p) == package for p in paths)


@lru_cache(maxsize=2)  # the launch files of a workspace are queried one after the other
def _launches(directory: str, resolver: Resolver) -> tuple[Launch, ...]:
    return tuple(read_launch(source, resolver) for source in launch_files(directory, "", resolver))


@lru_cache(maxsize=4)  # the robots of a package, and their SRDFs, are queried in turn
def _started(
    directory: str, mentioned: str, resolver: Resolver, *, only_parameters: bool = False
) -> tuple[tuple[str, RobotArguments], ...]:
    """The robots that the launch files of a directory start."""
    return tuple(
        one
        for source in launch_files(directory, mentioned, resolver)
        if not only_parameters or _LOADING.search(source.data)
        for choice in _choices(source)
        for one in started(read_launch(source, resolver, choice), source.path)
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
    default: str | None  # None if there is none, or if it is known at run time only
    is_open: bool  # True if there is none


def _declared(source: Source, *, with_defaults: bool) -> dict[str, list[str]]:
    """The choices of the arguments of a launch file.

    Args:
        with_defaults: also those of arguments with a default, and defaults without choices.
    """
    found: dict[str, list[str]] = {}
    for one in _of_python(source) if source.path.endswith(".py") else _of_xml(source):
        values = [choice for choice in one.choices if choice]
        if with_defaults and not values and one.default is not None:
            values = [one.default]
        if one.name and values and (with_defaults or one.is_open):
            found[one.name] = values
    return found


def _of_python(source: Source) -> Iterator[_Argument]:
    import ast

    from urdfkit.ros.launch.values import argument, called
    from urdfkit.text import python_source

    try:
        tree = python_source.parse(source.data)
    except SyntaxError:
        return  # which its own check reports
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
