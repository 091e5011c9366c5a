"""The arguments that the launch files of a package give to one of its robots."""

from __future__ import annotations

import ast
import os
from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache
from itertools import islice

from urdfkit import pythontext
from urdfkit.document import Element, Frame
from urdfkit.errors import UnreadableFile
from urdfkit.launch import read_launch
from urdfkit.launch.found import Description
from urdfkit.launch.markup import parsed
from urdfkit.launch.signature import arguments_in
from urdfkit.launch.values import argument, called
from urdfkit.reading import Problem, is_launch
from urdfkit.record import Record
from urdfkit.source import Source
from urdfkit.workspace.resolve import Resolver

#: Launch files of a package that are read, and folders in which they are looked for.
MAX_FILES, MAX_FOLDERS = 200, 2000
#: Sets of arguments that are taken of one robot; the UR arms have nine.
MAX_GIVEN = 16


class Given(Record):
    """Arguments of a robot.

    Attributes:
        arguments: for xacro.
        launch: path of the launch file that gives them.
        frame: its place; None if it gives them to another robot.
    """

    arguments: dict[str, str]
    launch: str
    frame: Frame | None


def given(robot: str, needed: Collection[str], resolver: Resolver) -> list[Given]:
    """What launch files give to a robot that lacks arguments, each set of them once.

    That is what the launch files of its package start it with. If none of them does, it is those
    of the needed arguments that they give to the other robots of the package: a launch file may
    be told which one to start.

    Args:
        robot: path of the URDF or xacro.
        needed: names of the arguments that it lacks.
        resolver: finds packages, and reads files.
    """
    real = os.path.realpath(robot)
    own: dict[tuple[tuple[str, str], ...], Given] = {}
    others: dict[tuple[str, ...], Given] = {}
    package = resolver.packages.enclosing(robot)
    for launch, description in _descriptions(package[1], resolver) if package else ():
        arguments = description.arguments
        if not arguments.keys() >= set(needed):
            continue
        if os.path.realpath(description.path) == real:
            key = tuple(sorted(arguments.items()))
            own.setdefault(key, Given(arguments, launch, description.frame))
        else:
            chosen = {name: arguments[name] for name in needed}
            others.setdefault(tuple(chosen.values()), Given(chosen, launch, None))
    return list(islice((own or others).values(), MAX_GIVEN))


def with_values(problems: Iterable[Problem], robot: str, resolver: Resolver) -> Iterator[Problem]:
    """What reading met; of arguments without a value it is told which ones launch files give.

    Args:
        problems: of a description.
        robot: its path.
        resolver: finds packages, and reads files.
    """
    for problem in problems:
        name = missing_argument(problem)
        sets = given(robot, (name,), resolver) if name else []
        values = ", ".join(dict.fromkeys(one.arguments[name] for one in sets))
        files = ", ".join(dict.fromkeys(os.path.basename(one.launch) for one in sets))
        more = f"; launch files give {values} ({files})" if sets else ""
        yield problem._replace(help=problem.help + more)


def missing_argument(problem: Problem) -> str:
    """The argument without which a xacro cannot be expanded; empty if that is not the problem."""
    return problem.message.split("'")[1] if problem.code == "XAC010" else ""


@lru_cache(maxsize=1)  # the robots of a package are asked for one after the other
def _descriptions(folder: str, resolver: Resolver) -> tuple[tuple[str, Description], ...]:
    """The robots that the launch files of a package start, with the path of the launch file."""
    return tuple(_read(folder, resolver))


def _read(folder: str, resolver: Resolver) -> Iterator[tuple[str, Description]]:
    files = filter(is_launch, resolver.folders.files_below(folder, MAX_FOLDERS))
    for path in islice(files, MAX_FILES):
        try:
            source = resolver.read(path)
        except UnreadableFile:
            continue  # a dangling link, or no permission
        for choice in _choices(source):
            for description in read_launch(source, resolver, choice).descriptions:
                yield path, description


def _choices(source: Source) -> Iterator[dict[str, str]]:
    """Ways to start a launch file.

    An argument without a default takes each of its choices; the others then their first one.
    """
    choices = _of_python(source) if source.path.endswith(".py") else _of_xml(source)
    first = {name: values[0] for name, values in choices.items()}
    yield first
    for name, values in choices.items():
        for value in values[1:]:
            yield first | {name: value}


def _of_python(source: Source) -> dict[str, list[str]]:
    try:
        tree = pythontext.parse(source.data)
    except SyntaxError:
        return {}  # which its own check tells
    found: dict[str, list[str]] = {}
    for call in ast.walk(tree):
        if not isinstance(call, ast.Call) or called(call) != "DeclareLaunchArgument":
            continue
        name, choices = argument(call, 0, "name"), argument(call, None, "choices")
        if argument(call, 1, "default_value") is None and isinstance(
            choices, (ast.List, ast.Tuple)
        ):
            values = [text for text in map(_constant, choices.elts) if text]
            if values and (word := _constant(name)):
                found[word] = values
    return found


def _constant(node: ast.expr | None) -> str:
    value = node.value if isinstance(node, ast.Constant) else None
    return value if isinstance(value, str) else ""


def _of_xml(source: Source) -> dict[str, list[str]]:
    document, _ = parsed(source)
    declared: Iterator[Element] = arguments_in(document.root) if document else iter(())
    found: dict[str, list[str]] = {}
    for element in declared:
        values = [child.get("value") or "" for child in element.children if child.tag == "choice"]
        name = element.get("name")
        if name and all(values) and values and not {"default", "value"} & set(element.attributes):
            found[name] = values
    return found
