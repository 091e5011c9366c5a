"""The ``urdfkit`` command as click has it: a group of commands, each imported when used."""

from __future__ import annotations

from collections.abc import Sequence
from importlib import import_module

import click

from urdfkit import __version__
from urdfkit.cli.options import UsageError

#: ``urdfkit.cli.<name>`` has each of them as ``command``, a click.Command that returns the
#: exit code.
COMMANDS = (
    "check",
    "fix",
    "expand",
    "trace",
    "explain",
    "rules",
    "info",
    "tree",
    "gazebo",
    "migrate",
    "diff",
    "init",
    "doctor",
)


class LazyGroup(click.Group):
    """A group that imports a command when it is asked for."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in COMMANDS:
            return None
        command = import_module(f"urdfkit.cli.{cmd_name}").command
        assert isinstance(command, click.Command)
        return command


@click.group("urdfkit", cls=LazyGroup)
@click.version_option(__version__, message="urdfkit %(version)s")
def group() -> None:
    """Check robot models in URDF and xacro."""


def run(words: Sequence[str]) -> int:
    """Run a command line and return its exit code.

    Raises:
        UsageError: it cannot be understood.
        KeyboardInterrupt: Ctrl-C.
    """
    try:
        code = group.main(list(words) or ["--help"], "urdfkit", standalone_mode=False)
    except click.Abort as error:
        raise KeyboardInterrupt from error
    except click.UsageError as error:
        message = " ".join(error.format_message().split())
        command = error.ctx.command_path if error.ctx else "urdfkit"
        raise UsageError(f"{message} (see '{command} --help')") from error
    assert isinstance(code, int)
    return code
