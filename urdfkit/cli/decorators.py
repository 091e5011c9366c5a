"""Decorators that several commands share: examples in their help, and options."""

from collections.abc import Callable, Iterable
from inspect import cleandoc
from typing import Any, TypeVar

import click

from urdfkit.cli.options import Option
from urdfkit.core import limits

Command = TypeVar("Command", bound=Callable[..., Any])


def examples(*lines: str) -> str:
    """Command lines as a list that click does not wrap."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)


def described(
    name: str, cls: type[click.Command] = click.Command
) -> Callable[[Callable[..., Any]], click.Command]:
    """``click.command`` for a function whose docstring is the help, with examples at its end."""

    def decorate(command: Callable[..., Any]) -> click.Command:
        text, _, lines = cleandoc(command.__doc__ or "").partition("\n\nExamples:\n")
        epilog = examples(*map(str.strip, lines.splitlines())) if lines else None
        return click.command(name, cls, help=text, epilog=epilog)(command)

    return decorate


def with_options(*options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Add several options to a command; the last one is listed first."""

    def decorate(command: Command) -> Command:
        for add in options:
            command = add(command)
        return command

    return decorate


def option(
    usage: str, help: str, *, to: str | None = None, **more: Any
) -> Callable[[Command], Command]:
    """Add an option to a command, written as in its help; without a value it is a switch.

    >>> force = option("--force", "Replace OUT if it is a bundle.")
    >>> output = option("-o, --output FILE", "Image to write.")

    Args:
        to: the parameter of the command that gets the value. [default: the option's name]
        more: further arguments of `click.option`.
    """
    words = usage.split()
    flags = [word.rstrip(",") for word in words if word.startswith("-")]
    metavar = " ".join(words[len(flags) :])
    names = (*flags, to) if to else flags
    more |= {"metavar": metavar} if metavar else {"is_flag": True}
    return click.option(*names, help=help, **more)


def click_option(option: Option, **more: Any) -> click.Option:
    """An option of the table (`urdfkit.cli.options`) as a click option."""
    return click.Option(
        [flag for flag in (option.short, option.flag) if flag],
        help=option.help,
        is_flag=not option.metavar,
        metavar=option.metavar or None,
        multiple=option.many,
        type=click.Choice(option.choices) if option.choices else None,
        default=None if option.many else option.initial,
        show_default=bool(option.choices),
        **more,
    )


def choice(*names: str, of: Iterable[str], help: str) -> Callable[[Command], Command]:
    """Add an option with a choice of words to a command; the first word is the default."""
    words = list(of)
    return click.option(*names, type=click.Choice(words), default=words[0], help=help)


def in_formats(*formats: str) -> Callable[[Command], Command]:
    """Add the option ``--format`` as parameter ``format``; the first format is the default."""
    return choice("--format", "format", of=formats, help="Output format.")


def to_file(name: str, help: str) -> Callable[[Command], Command]:
    """Add the option ``-o`` to a command; without it, and for '-', the value is None (stdout)."""
    return click.option(
        "-o",
        "--output",
        name,
        metavar="FILE",
        help=help,
        callback=lambda context, option, file: None if file == "-" else file,
    )


def no_stream(context: click.Context, option: click.Parameter, out: str) -> str:
    """Reject '-', which other commands interpret as standard output."""
    if out == "-":
        raise click.BadParameter("'-' is not a directory; pass './-' for a directory of that name")
    return out


OUT = option(
    "-o, --output OUT", "Directory or .zip to write.", to="out", required=True, callback=no_stream
)
TRUST = option("--trust", "Let the model run any expression and read any file.")
PACKAGE = option("--package NAME=DIR", "Directory of a ROS package.", multiple=True)
ISOLATED = option("--isolated", "Ignore all configuration files.")
CONFIG = option("--config FILE", "Configuration file. [default: the nearest one]")
VARIANT = option("--variant NAME", "Variant in the configuration.", default="", show_default=False)
TARGET = option("--target NAMES", "Target program. [default: detected]", multiple=True)
DIFF = option("--diff", "Show what --write would change.")
SEED = option("--seed N", "Seed of the samples.", type=click.IntRange(0), default=0)
RULES = option(
    "--rules NAMES", "Rule packages to load: installed names, or modules.", multiple=True
)

#: Add options for the limits of memory and time, which apply from the parsing of the option on.
limited = with_options(
    option(
        "--memory GIB",
        "Limit of memory.",
        type=click.FloatRange(0.1),
        default=8,
        expose_value=False,
        callback=lambda context, option, size: limits.begin_memory(int(size * 2**30)),
    ),
    option(
        "--timeout SECONDS",
        "Limit of time, until the result is written.",
        type=click.FloatRange(0.01, 1_000_000),
        default=300,
        expose_value=False,
        callback=lambda context, option, seconds: limits.begin_time(seconds),
    ),
)
