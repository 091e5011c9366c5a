"""Arguments and options of the commands for a single robot."""

import os
from collections.abc import Callable, Mapping, Sequence
from contextlib import nullcontext
from functools import wraps
from typing import Any, cast

import click

from urdfkit.cli import options, output, stdin
from urdfkit.cli.decorators import (
    CONFIG,
    ISOLATED,
    PACKAGE,
    TARGET,
    TRUST,
    VARIANT,
    Command,
    with_options,
)
from urdfkit.cli.progress import working
from urdfkit.core.progress import Progress
from urdfkit.core.suggest import hint_for
from urdfkit.core.words import counted, few
from urdfkit.errors import UnreadableFile, UnreadableRobot
from urdfkit.lint import rule_index
from urdfkit.lint.config import Config
from urdfkit.lint.context import Context
from urdfkit.lint.discovery import discover
from urdfkit.lint.loading import read, require_robot
from urdfkit.lint.options import Options
from urdfkit.lint.unknown_arguments import unknown_arguments
from urdfkit.text.diagnostic import Problem, Severity
from urdfkit.text.source import shown
from urdfkit.workspace.resolve import Resolver

#: Most robots of a directory that an error lists.
_NAMED = 5

#: The options for reading a robot, and the keys of their values.
_READING = (TRUST, ISOLATED, CONFIG, VARIANT, PACKAGE)
_KEYS = (options.FILES, "package", "variant", "config", "isolated", "trust", "joint", "pose")

#: Adds the options for reading a robot to a command, without its FILE argument.
read_by_options = with_options(*_READING)


def one_robot(command: Callable[..., int]) -> Callable[..., int]:
    """Add the arguments ``FILE [NAME:=VALUE]...`` and the options for reading it to a command.

    The command receives all values, and those of `posed`, as ``inputs`` for the functions `robot`,
    `reading` and `positions`.
    """

    @wraps(command)
    def collected(**values: Any) -> int:
        inputs = {key: values.pop(key) for key in _KEYS if key in values}
        return command(inputs=inputs, **values)

    words = click.argument(options.FILES, nargs=-1, required=True, metavar="FILE [NAME:=VALUE]...")
    return read_by_options(words(collected))


def with_robot_and_targets(metavar: str = "FILE [NAME:=VALUE]...") -> Callable[[Command], Command]:
    """Add arguments, the options for reading them, and ``--target`` to a command.

    The functions of `options` take their values.
    """
    words = click.argument(options.FILES, nargs=-1, required=True, metavar=metavar)
    return with_options(words, TARGET, *_READING)


def only_file(values: Mapping[str, Any]) -> str:
    """The only file of a command line.

    Raises:
        UsageError: there is no file, or more than one.
    """
    files = options.files(values)
    if len(files) != 1:
        raise options.UsageError("expected one file; xacro arguments have the form name:=value")
    if os.path.isdir(files[0]):
        raise options.UsageError(f"{files[0]}: is a directory; {_robots_in(files[0])}")
    return files[0]


def last_file(states: Sequence[str]) -> str:
    """The last state that is a file, whose configuration is used; else the current directory."""
    return next((file for file in reversed(states) if os.path.exists(file)), os.curdir)


def _robots_in(directory: str) -> str:
    """A hint to pass a robot of a directory instead of the directory."""
    try:
        robots = discover(directory, Config(), Resolver()).robots
    except UnreadableFile:
        return "pass a robot file"
    return f"pass one of its robots: {few([shown(robot.file) for robot in robots], _NAMED)}"


def reading(inputs: Mapping[str, Any], file: str) -> Options:
    """The options for reading the robot in a file, from the command line or the configuration.

    Args:
        inputs: the values of the arguments and options of `one_robot`.

    Raises:
        ConfigError: the robot has several variants and none is selected, or the variant is unknown.
    """
    config = options.config(inputs, file) or Config()
    entry = config.entry(file, options.arguments(inputs), inputs["variant"])
    packages = {**config.packages, **options.packages(inputs)}
    trust = inputs["trust"] or config.trust
    return Options(arguments=entry.arguments, packages=packages, trust=trust)


def robot(inputs: Mapping[str, Any], progress: Progress | None = None) -> Context:
    """The robot of a command line.

    Args:
        inputs: the values of the arguments and options of `one_robot`.
        progress: called with the number of mesh files read and the number of all mesh files.

    Raises:
        UsageError: there is no file, or more than one.
        UrdfkitError: the file cannot be read, or has no link.
    """
    file = only_file(inputs)
    read_options = reading(inputs, file)
    try:
        with working() if progress is None else nullcontext():
            context = read(
                stdin.opened(file),
                arguments=read_options.arguments,
                packages=read_options.packages,
                trust=read_options.trust,
                progress=progress,
            )
    except UnreadableRobot as error:
        if not error.problems:
            raise
        raise first_error(error, file) from error
    require_robot(context)
    if not context.model.links:
        raise UnreadableRobot(context.tree.unsound)
    for launched in context.launched:
        values = " ".join(f"{name}:={value}" for name, value in launched.arguments.items())
        output.note(f"read with {values} of {shown(launched.launch)}")
    for name, suggested in unknown_arguments(context, options.arguments(inputs)).items():
        output.note(f"the robot has no argument '{name}'{hint_for(suggested)}")
    return context


def first_error(error: UnreadableRobot, file: str) -> UnreadableRobot:
    """The error with its first reason only: a missing package is often missing in every file."""
    problems = cast(tuple[Problem, ...], error.problems)
    # Findings that are not errors may not be the reason.
    problems = (
        tuple(p for p in problems if rule_index.get(p.code).severity is Severity.ERROR) or problems
    )
    if not problems:
        return error
    first, others = problems[0], len(problems) - 1
    reason = f"{first.message}; {first.help}" if first.help else first.message
    more = f", which reports {counted(others, 'finding')} more" if others else ""
    hint = "" if "urdfkit check" in reason else f"; see 'urdfkit check {file}'{more}"
    return UnreadableRobot(f"{first.span}: {reason}{hint}", problems)
