"""Pieces of a command have no blank between them and become one word.

`Command` joins its pieces as they are. `["xacro", path]` runs a program called `xacro/home/...`,
which does not exist; in `["xacro ", path, "sim:=true"]` the argument becomes part of the file name.
Write the blanks: `["xacro ", path, " sim:=true"]`.

Sources:
    launch, command.py: https://github.com/ros2/launch/blob/rolling/launch/launch/substitutions/command.py
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, reported, rule
from urdfkit.text.diagnostic import Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject

NAME = "robot.launch.py"
BAD = """\
from launch.substitutions import Command, PathJoinSubstitution

description = Command(["xacro ", PathJoinSubstitution(["urdf", "arm.xacro"]), "sim:=true"])
"""
GOOD = BAD.replace('"sim', '" sim')


@rule("LAU011", "words-run-together", Severity.ERROR, needs=(Need.LAUNCH,))
def check(subject: Subject) -> Iterator[Finding]:
    yield from reported(subject, "LAU011")
