"""The words and options of every command that reads one robot."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar, cast

import click

from urdfkit.cli import options
from urdfkit.errors import UnreadableRobot
from urdfkit.loading import read
from urdfkit.meshes.facts import counted
from urdfkit.subject import Subject

if TYPE_CHECKING:
    from urdfkit.reading import Problem

Command = TypeVar("Command", bound=Callable[..., Any])


def one_robot(command: Command) -> Command:
    """Give a command the words ``FILE [NAME:=VALUE]...`` and the options of reading it."""
    for add in (
        click.option(
            "--trust", is_flag=True, help="Let the model run any expression, read any file."
        ),
        click.option(
            "--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is."
        ),
        click.argument("words", nargs=-1, required=True, metavar="FILE [NAME:=VALUE]..."),
    ):
        command = add(command)
    return command


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
    files = options.files(values)
    if len(files) != 1:
        raise options.UsageError("name one file; xacro arguments are written name:=value")
    try:
        return read(
            files[0],
            arguments=options.arguments(values),
            packages=options.packages(values),
            trust=trust,
            progress=progress,
        )
    except UnreadableRobot as error:
        raise _first_of(error, files[0]) from error


def _first_of(error: UnreadableRobot, file: str) -> UnreadableRobot:
    """The first of many reasons: a package that is missing is often missing in every file."""
    problems = cast("tuple[Problem, ...]", error.problems)
    if not problems:
        return error
    first, others = problems[0], len(problems) - 1
    more = f", which tells {counted(others, 'error')} more" if others else ""
    text = f"{first.span}: {first.message}; see 'urdfkit check {file}'{more}"
    return UnreadableRobot(text, problems)
