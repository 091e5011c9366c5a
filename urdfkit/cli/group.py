"""The ``urdfkit`` command: a click group of commands, each imported when it is used."""

import os
from collections.abc import Sequence
from itertools import chain

import click

from urdfkit import __version__
from urdfkit.cli.completion import VARIABLE, register
from urdfkit.cli.lazy import LazyGroup
from urdfkit.cli.options import UsageError
from urdfkit.core.suggest import nearest

#: Commands by section of the help. ``urdfkit.cli.<name>`` defines ``command``, a click.Command
#: that returns the exit code.
SECTIONS = {
    "Check and fix": "check fix format migrate scan".split(),
    "Expand xacro": "expand trace".split(),
    "Inspect a robot": (
        "info tree kinematics mass inertia statics collisions simulate importers gazebo diff"
    ).split(),
    "Show a robot": "render view report".split(),
    "Mesh files and copies": "mesh bundle convert".split(),
    "Rules and set-up": "rules explain new init doctor clean completion lsp mcp".split(),
}
COMMANDS = tuple(chain.from_iterable(SECTIONS.values()))


@click.group(
    "urdfkit",
    cls=LazyGroup,
    package="urdfkit.cli",
    sections=SECTIONS,
    context_settings={"help_option_names": ["-h", "--help"], "show_default": True},
)
@click.version_option(__version__, "-V", "--version", message="urdfkit %(version)s")
def group() -> None:
    """Check robot models in URDF and xacro."""


def run(words: Sequence[str]) -> int:
    """Run a command line and return its exit code.

    Raises:
        UsageError: the command line is invalid.
        KeyboardInterrupt: Ctrl-C.
    """
    if VARIABLE in os.environ:
        register()
    try:
        code = group.main(list(words) or ["--help"], "urdfkit", standalone_mode=False)
    except click.Abort as error:
        raise KeyboardInterrupt from error
    except click.UsageError as error:
        message = " ".join(error.format_message().split()).removesuffix(".")
        message = message.replace("a valid float range", "a number")
        message = message.replace("a valid integer range", "an integer")
        if isinstance(error, click.NoSuchOption):  # click's message has three sentences
            # The dashes, which all have, make none similar.
            known = [option.lstrip("-") for option in error.possibilities or ()]
            near = nearest(error.option_name.lstrip("-"), known)
            hint = f"; did you mean '--{near}'?" if near else ""
            message = f"no such option '{error.option_name}'{hint}"
        message = message[:1].lower() + message[1:]  # like all other errors
        # If click omits the context, the cause is an option of the command.
        command = error.ctx.command_path if error.ctx else f"urdfkit {words[0]}"
        raise UsageError(f"{message} (see '{command} --help')") from error
    assert isinstance(code, int)
    return code
