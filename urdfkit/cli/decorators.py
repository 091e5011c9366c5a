"""What several commands have in common: examples in their help, and options."""

from collections.abc import Callable, Iterable
from typing import Any, TypeVar

import click

from urdfkit.core import limits

Command = TypeVar("Command", bound=Callable[..., Any])


def examples(*lines: str) -> str:
    """Command lines as a list, which click leaves as it is."""
    return "\b\nExamples:\n" + "\n".join(f"  {line}" for line in lines)


def with_examples(name: str, *lines: str) -> Callable[[Callable[..., Any]], click.Command]:
    """``click.command`` for a command whose help ends with some command lines."""
    return click.command(name, epilog=examples(*lines))


def with_options(*options: Callable[[Any], Any]) -> Callable[[Command], Command]:
    """Give a command several options, of which the last is listed first."""

    def decorated(command: Command) -> Command:
        for add in options:
            command = add(command)
        return command

    return decorated


def choice(*names: str, of: Iterable[str], help: str) -> Callable[[Command], Command]:
    """Give a command an option that takes one of some words; the first is the default."""
    words = list(of)
    return click.option(*names, type=click.Choice(words), default=words[0], help=help)


def in_formats(*formats: str) -> Callable[[Command], Command]:
    """Give a command the option ``--format``, as ``form``; the first format is the default."""
    return choice("--format", "form", of=formats, help="Output format.")


def to_file(name: str, help: str) -> Callable[[Command], Command]:
    """Give a command the option ``-o``; None is standard output, and so is '-'."""
    return click.option(
        "-o",
        "--output",
        name,
        metavar="FILE",
        help=help,
        callback=lambda context, option, file: None if file == "-" else file,
    )


def _no_stream(context: click.Context, option: click.Parameter, out: str) -> str:
    """Rejects '-', of which other commands make standard output."""
    if out == "-":
        raise click.BadParameter("'-' is no directory; pass './-' for one of that name")
    return out


OUT = click.option(
    "-o",
    "--output",
    "out",
    metavar="OUT",
    required=True,
    help="Directory or .zip to write.",
    callback=_no_stream,
)
TRUST = click.option(
    "--trust", is_flag=True, help="Let the model run any expression and read any file."
)
PACKAGE = click.option(
    "--package", multiple=True, metavar="NAME=DIR", help="Directory of a ROS package."
)
ISOLATED = click.option("--isolated", is_flag=True, help="Ignore all configuration files.")
CONFIG = click.option(
    "--config", metavar="FILE", help="Configuration file. [default: the nearest one]"
)
VARIANT = click.option(
    "--variant",
    default="",
    show_default=False,
    metavar="NAME",
    help="Variant in the configuration.",
)
TARGET = click.option(
    "--target", multiple=True, metavar="NAMES", help="Target program. [default: detected]"
)
COLOR = click.option(
    "--color",
    type=click.Choice(["auto", "always", "never"]),
    default="auto",
    metavar="WHEN",
    help="Colours on standard output: auto, always or never.",
)
DIFF = click.option("--diff", is_flag=True, help="Show what --write would change.")
SEED = click.option("--seed", type=click.IntRange(0), default=0, help="Seed of the samples.")
RULES = click.option(
    "--rules",
    multiple=True,
    metavar="NAMES",
    help="Rule packages to load: installed names, or modules.",
)

#: Gives a command that computes the limits of its process; they hold from here on.
limited = with_options(
    click.option(
        "--memory",
        type=click.FloatRange(0.1),
        default=8,
        metavar="GIB",
        expose_value=False,
        callback=lambda context, option, size: limits.begin_memory(int(size * 2**30)),
        help="Limit of memory.",
    ),
    click.option(
        "--timeout",
        type=click.FloatRange(0.01, 1_000_000),
        default=300,
        metavar="SECONDS",
        expose_value=False,
        callback=lambda context, option, seconds: limits.begin_time(seconds),
        help="Limit of time, until the result is written.",
    ),
)
