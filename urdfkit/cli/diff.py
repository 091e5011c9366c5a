"""``urdfkit diff``: compare two states of a robot."""

from functools import partial
from importlib import import_module
from typing import Any

import click

from urdfkit.cli import options, output
from urdfkit.cli.decorators import described, limited, option, to_file
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import last_file, with_robot_and_targets
from urdfkit.core import atomic
from urdfkit.output.comparison import KINDS, compare
from urdfkit.output.comparison.differences import Tolerances
from urdfkit.output.report.translations import LANGUAGES
from urdfkit.output.report.writing import form_of

#: Formats by file suffix.
SUFFIXES = {".txt": "text", ".json": "json", ".md": "markdown", ".html": "html"}
_NUMBERS = [name for name, value in Tolerances._field_defaults.items() if value is not False]


@described("diff")
@with_robot_and_targets("BEFORE AFTER [NAME:=VALUE]...")
@click.option(
    "--format",
    "format",
    type=click.Choice([*SUFFIXES.values()]),
    help="Output format. [default: text]",
)
@to_file("output_file", "Write to FILE; its suffix is the format.")
@option(
    "--fail-on KINDS",
    f"Differences that make the exit code 1: any, none, or some of {', '.join(KINDS)}.",
    default="any",
)
@option(
    "--tolerance NAME=VALUE",
    f"Tolerances: {', '.join(_NUMBERS)}; in m and rad, or relative.",
    multiple=True,
)
@click.option(
    "--lang", type=click.Choice(LANGUAGES), help="Language of the HTML page. [default: en]"
)
@limited
def command(
    format: str | None,
    output_file: str | None,
    fail_on: str,
    tolerance: tuple[str, ...],
    lang: str | None,
    **values: Any,
) -> int:
    """Compare two robot models by their parts, not by their text.

    BEFORE and AFTER are files, or files of a git revision, such as HEAD~1:urdf/robot.urdf.xacro.
    Compares links, joints, limits, masses, inertias, shapes, mesh surfaces, link poses, the total
    mass and centre of mass, and the findings of urdfkit check.

    Exit codes: 0 no differences, 1 differences of --fail-on, 2 usage or input error.

    Examples:
        urdfkit diff HEAD:urdf/robot.urdf.xacro urdf/robot.urdf.xacro
        urdfkit diff old.urdf new.urdf --fail-on joints,limits --tolerance mass=0.01
    """
    files = options.files(values)
    if len(files) != 2:
        raise options.UsageError("expected two files; xacro arguments have the form name:=value")
    if "-" in files:
        raise options.UsageError("standard input cannot be compared; pass a file")
    name = _format(format, output_file)
    render = import_module(f"urdfkit.output.comparison.{name}").render
    if lang:
        if name != "html":
            raise options.UsageError("--lang is for HTML: write -o diff.html, or --format html")
        render = partial(render, language=lang)
    counted = _kinds(fail_on)
    before, after = files
    with progress_bar("steps") as bar:
        comparison = compare(
            before,
            after,
            options.check_options(values, last_file(files)),
            tolerances=_tolerances(tolerance),
            has_images=name == "html",
            progress=bar,
        )
    if output_file:
        atomic.write(output_file, output.encode(render(comparison)))
    else:
        output.write(render(comparison, width=output.width()))
    return int(not counted.isdisjoint(comparison.kinds))


def _format(format: str | None, output_file: str | None) -> str:
    if format or not output_file:
        return format or "text"
    return form_of(output_file, SUFFIXES)


def _kinds(text: str) -> set[str]:
    words = {word.strip() for word in text.split(",") if word.strip()}
    if unknown := words - {*KINDS, "any", "none"}:
        known = ", ".join(("any", "none", *KINDS))
        raise options.UsageError(f"--fail-on {min(unknown)}: write some of {known}")
    return set(KINDS) if "any" in words else words


def _tolerances(words: tuple[str, ...]) -> Tolerances:
    tolerances: dict[str, float] = {}
    for word in words:
        name, _, text = word.partition("=")
        if name not in _NUMBERS:
            raise options.UsageError(f"--tolerance {word}: write one of {', '.join(_NUMBERS)}")
        try:
            tolerances[name] = float(text)
        except ValueError:
            tolerances[name] = -1.0
        if not tolerances[name] >= 0:
            raise options.UsageError(f"--tolerance {word}: write a number from 0")
    return Tolerances(**tolerances)  # type: ignore[arg-type]
