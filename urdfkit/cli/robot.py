"""The words and options of every command that reads one robot."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, TypeVar

import click

from urdfkit.cli import options
from urdfkit.errors import UnreadableRobot
from urdfkit.loading import read
from urdfkit.subject import Subject

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


def robot(words: tuple[str, ...], package: tuple[str, ...], trust: bool) -> Subject:
    """The robot that a command line names.

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
        )
    except UnreadableRobot as error:
        text = f"{files[0]} cannot be read; 'urdfkit check' tells why"
        raise UnreadableRobot(text, error.problems) from error
