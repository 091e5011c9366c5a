"""Click groups that import each command when it is used."""

import os
from collections.abc import Mapping, Sequence
from importlib import import_module
from itertools import chain
from typing import Any

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import click_option
from urdfkit.cli.options import COLOR
from urdfkit.core.installation import install_command
from urdfkit.core.suggest import did_you_mean
from urdfkit.errors import UrdfkitError

#: Commands of other tools, with the command of urdfkit.
_ELSEWHERE = {
    "lint": "check",
    "validate": "check",
    "verify": "check",
    "xacro": "expand",
    "show": "view",
    "help": "--help",
    "version": "--version",
}


#: The option that a group adds to each of its commands.
_COLOR = click_option(
    COLOR,
    expose_value=False,
    is_eager=True,  # for the errors of the other options
    callback=lambda context, option, when: output.use_color(when),
)


class MissingExtra(UrdfkitError):
    """A command needs a library that is not installed."""


class LazyGroup(click.Group):
    """A group that imports each command when it is used.

    Args:
        package: package with a module for each command, which defines ``command``.
        sections: names of commands by heading in the help.
        extra: extra of urdfkit that the commands require.
    """

    def __init__(
        self,
        *args: Any,
        package: str,
        sections: Mapping[str, Sequence[str]],
        extra: str = "",
        **more: Any,
    ) -> None:
        super().__init__(*args, **more)
        self.package = package
        self.sections = sections
        self.names = tuple(chain.from_iterable(sections.values()))
        self.extra = extra

    def list_commands(self, ctx: click.Context) -> list[str]:
        return list(self.names)

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        longest = max(map(len, self.names))
        limit = formatter.width - 6 - longest
        missing: dict[str, None] = {}
        for heading, names in self.sections.items():
            rows = []
            for name in names:
                try:
                    command = self.get_command(ctx, name)
                    text = command.get_short_help_str(limit) if command else ""
                except MissingExtra as error:
                    missing[str(error)] = None
                    text = ""
                rows.append((name.ljust(longest), text))
            with formatter.section(heading):
                formatter.write_dl(rows)
        for reason in missing:
            formatter.write_paragraph()
            formatter.write_text(reason)

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        word = args[0]
        if word not in self.names and not word.startswith("-"):
            suggested = _ELSEWHERE.get(word) if ctx.parent is None else None
            hint = f"; did you mean '{suggested}'?" if suggested else did_you_mean(word, self.names)
            if os.path.exists(word):
                hint = f"; to check that file: urdfkit check {word}"
            raise click.UsageError(f"unknown command '{word}'{hint}", ctx)
        return super().resolve_command(ctx, args)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        if cmd_name not in self.names:
            return None
        try:
            command = import_module(f"{self.package}.{cmd_name}").command
        except ModuleNotFoundError as error:
            if not self.extra or (error.name or "").startswith("urdfkit"):
                raise
            install = install_command(self.extra)
            raise MissingExtra(
                f"'{ctx.command_path}' needs {error.name}, which is not installed: {install}"
            ) from error
        assert isinstance(command, click.Command)
        if not isinstance(command, click.Group) and _COLOR not in command.params:
            command.params.append(_COLOR)
        return command
