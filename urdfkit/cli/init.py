"""``urdfkit init``: a first configuration from what is found."""

from __future__ import annotations

import os

import click

from urdfkit import atomic
from urdfkit.cli import output
from urdfkit.config import Config, Robot
from urdfkit.discovery import Found, discover
from urdfkit.errors import UnwritableFile
from urdfkit.expansion import Xacro, expand
from urdfkit.reading import is_xacro
from urdfkit.resolve import Resolver
from urdfkit.source import Source

_FILE = "urdfkit.toml"


@click.command("init")
@click.argument("folder", default=os.curdir)
@click.option("--print", "only_print", is_flag=True, help="Print it, write nothing.")
def command(folder: str, only_print: bool) -> int:
    """Write a first urdfkit.toml for the robots in FOLDER.

    It names every robot that is found, with the arguments that it needs. An urdfkit.toml that
    exists is left alone.

    Exit codes: 0 written, 2 there is no robot, or the file exists.
    """
    found = discover(folder, Config(), Resolver())
    text = render(found, folder)
    path = os.path.join(folder, _FILE)
    if only_print:
        output.write(text)
        return 0
    if os.path.exists(path):
        raise UnwritableFile(f"{path}: exists already; --print shows what would be written")
    atomic.write(path, text.encode())
    output.write(f"{path}: {len(found.robots)} robots; now run: urdfkit check {folder}\n")
    return 0


def render(found: Found, folder: str) -> str:
    """The text of a configuration."""
    lines = [
        "# Settings of urdfkit; see 'urdfkit check --help'.",
        '# targets = ["ros2", "gz-harmonic"]  # inferred from each model if not given',
        '# ignore = ["GEO002"]',
        "",
    ]
    resolver = Resolver()
    for robot in found.robots:
        lines += _robot(robot, folder, resolver)
    return "\n".join(lines)


def _robot(robot: Robot, folder: str, resolver: Resolver) -> list[str]:
    file = os.path.relpath(robot.file, folder).replace(os.sep, "/")
    lines = ["[[robot]]", f"file = {_quoted(file)}"]
    source = Source.read(robot.file)
    if is_xacro(source):
        lines += _arguments(expand(source, resolver))
    return [*lines, ""]


def _arguments(xacro: Xacro) -> list[str]:
    """The arguments of a xacro: those it needs to be filled in, the others as comments."""
    needed = dict.fromkeys(
        problem.message.split("'")[1] for problem in xacro.problems if problem.code == "XAC010"
    )
    lines = [f'arguments.{name} = ""  # TODO: it has no usable default' for name in needed]
    for argument in xacro.arguments:
        if argument.name not in needed:
            default = argument.attributes.get("default", "")
            lines.append(f"# arguments.{argument.name} = {_quoted(default)}")
    return list(dict.fromkeys(lines))


def _quoted(text: str) -> str:
    """A text as TOML writes it."""
    import json  # a JSON text is a TOML text

    return json.dumps(text, ensure_ascii=False)
