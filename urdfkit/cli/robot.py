"""The words and options of every command that is about one robot."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any, TypeVar, cast

import click

from urdfkit import rules
from urdfkit.cli import options, stdin
from urdfkit.config import Config
from urdfkit.diagnostic import Severity
from urdfkit.discovery import discover
from urdfkit.errors import UnreadableFile, UnreadableRobot
from urdfkit.loading import read
from urdfkit.meshes.facts import counted
from urdfkit.plan import unknown_arguments
from urdfkit.screen import printable
from urdfkit.source import shown
from urdfkit.subject import Subject
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.reading import Problem

Command = TypeVar("Command", bound=Callable[..., Any])

#: Robots of a folder that an error names.
_NAMED = 5

_TRUST = click.option(
    "--trust", is_flag=True, help="Let the model run any expression, read any file."
)
_PACKAGE = click.option(
    "--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is."
)
_ISOLATED = click.option("--isolated", is_flag=True, help="Take no configuration.")
_CONFIG = click.option(
    "--config", metavar="FILE", help="The configuration. [default: the nearest one]"
)
_TARGET = click.option("--target", multiple=True, metavar="NAMES", help="Weigh findings for it.")


def one_robot(command: Command) -> Command:
    """Give a command the words ``FILE [NAME:=VALUE]...`` and the options of reading it."""
    words = click.argument("words", nargs=-1, required=True, metavar="FILE [NAME:=VALUE]...")
    for add in (_TRUST, _PACKAGE, words):
        command = add(command)
    return command


def judged(metavar: str = "FILE [NAME:=VALUE]...") -> Callable[[Command], Command]:
    """Give a command words, and the options of reading and of judging what they name.

    Their values are those that the functions of `options` take.
    """
    words = click.argument(options.FILES, nargs=-1, required=True, metavar=metavar)

    def decorated(command: Command) -> Command:
        for add in (_TRUST, _ISOLATED, _CONFIG, _PACKAGE, _TARGET, words):
            command = add(command)
        return command

    return decorated


def only_file(values: Mapping[str, Any]) -> str:
    """The one file that a command line names.

    Raises:
        UsageError: it names no file, or more than one.
    """
    files = options.files(values)
    if len(files) != 1:
        raise options.UsageError("name one file; xacro arguments are written name:=value")
    if os.path.isdir(files[0]):
        raise options.UsageError(f"{files[0]}: is a folder; {_robots_in(files[0])}")
    return files[0]


def _robots_in(folder: str) -> str:
    """What to name instead of a folder."""
    try:
        found = discover(folder, Config(), Resolver()).robots
    except UnreadableFile:
        return "name the file of a robot"
    paths = [shown(robot.file) for robot in found]
    more = f" and {len(paths) - _NAMED} more" if len(paths) > _NAMED else ""
    return f"name one of its robots: {', '.join(paths[:_NAMED])}{more}"


def robot(
    words: tuple[str, ...],
    package: tuple[str, ...],
    trust: bool,
    progress: Callable[[int, int], None] | None = None,
) -> Subject:
    """The robot that a command line names.

    Args:
        words: file and arguments.
        package: folders of packages.
        trust: let it run any expression.
        progress: is told how many of how many mesh files have been read.

    Raises:
        UsageError: it names no file, or more than one.
        UrdfkitError: the file cannot be read.
    """
    values = {options.FILES: words, "package": package}
    file = only_file(values)
    arguments = options.arguments(values)
    try:
        subject = read(
            stdin.opened(file),
            arguments=arguments,
            packages=options.packages(values),
            trust=trust,
            progress=progress,
        )
    except UnreadableRobot as error:
        raise first_of(error, file) from error
    for name, meant in unknown_arguments(subject, arguments).items():
        hint = f"; did you mean '{meant}'?" if meant else ""
        print(printable(f"note: the robot has no argument '{name}'{hint}"), file=sys.stderr)
    return subject


def first_of(error: UnreadableRobot, file: str) -> UnreadableRobot:
    """The first of many reasons: a package that is missing is often missing in every file."""
    problems = cast("tuple[Problem, ...]", error.problems)
    # What is told beside an error need not be why a file cannot be read.
    problems = (
        tuple(p for p in problems if rules.get(p.code).severity is Severity.ERROR) or problems
    )
    if not problems:
        return error
    first, others = problems[0], len(problems) - 1
    what = f"{first.message}; {first.help}" if first.help else first.message
    more = f", which tells {counted(others, 'error')} more" if others else ""
    return UnreadableRobot(f"{first.span}: {what}; see 'urdfkit check {file}'{more}", problems)
