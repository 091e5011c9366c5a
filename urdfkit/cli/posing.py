"""The options that set the joints of a robot, for every command that has a pose."""

from __future__ import annotations

import sys
from collections.abc import Callable
from typing import Any, TypeVar

import click

from urdfkit.cli import options
from urdfkit.lint.context import Subject
from urdfkit.physics.poses import outside_limits, pose
from urdfkit.text.terminal import printable

Command = TypeVar("Command", bound=Callable[..., Any])


def posed(command: Command) -> Command:
    """Give a command the options ``--joint`` and ``--pose``, as ``joint`` and ``pose``."""
    for add in (
        click.option(
            "--pose",
            metavar="FILE",
            help="Pose file, or an SRDF group state such as ready or arm.srdf:ready.",
        ),
        click.option(
            "--joint",
            multiple=True,
            metavar="NAME=VALUE",
            help="Joint position in rad or m, or in degrees such as 90deg.",
        ),
    ):
        command = add(command)
    return command


def positions(subject: Subject, joint: tuple[str, ...], name: str | None) -> dict[str, float]:
    """The positions that the options give; those outside the limits are reported.

    Raises:
        UsageError: ``--joint`` has no ``=``.
        PoseError: there is no such joint or pose.
    """
    given = {}
    for word in joint:
        key, equals, value = word.rpartition("=")
        if not (key and equals):
            raise options.UsageError(
                f"--joint {word}: expected NAME=VALUE: the joint and its position"
            )
        given[key] = value
    found = pose(subject, given, name)
    for sentence in outside_limits(subject.tree, found):
        print(f"note: {printable(sentence)}", file=sys.stderr)
    return found
