"""What ``urdfkit mesh spheres`` and ``urdfkit mesh capsules`` have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import TYPE_CHECKING

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import Command, choice, option, to_file, with_options
from urdfkit.cli.mesh import tables
from urdfkit.cli.progress import working
from urdfkit.core import atomic
from urdfkit.lint.context import Context
from urdfkit.output.covers import RobotCover
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.mesh.cover_quality import CoverQuality

#: Functions that write a format, by its name.
Formats = Mapping[str, Callable[[Context, RobotCover], str]]


def covering(
    shapes: str, formats: Formats, *, most: int, margin: float, margin_help: str
) -> Callable[[Command], Command]:
    """Options of a command that covers a robot with ``shapes``."""
    return with_options(
        option("--visual", "Cover the visual geometry."),
        option(
            "--coverage SHARE",
            f"Share of the volume of each link that the {shapes} cover.",
            type=click.FloatRange(0, 1, min_open=True, max_open=True),
            default=0.99,
        ),
        option(
            "--margin METRES",
            margin_help,
            type=click.FloatRange(0, 1, min_open=True),
            default=margin,
        ),
        option("--most N", f"Maximum number of {shapes}.", type=click.IntRange(1), default=most),
        choice(
            "--format",
            "format",
            of=[*formats, "json"],
            help=f"Format of --output; json is the table with the {shapes}.",
        ),
        to_file("out", f"Write the {shapes} to this file."),
    )


def write(
    shapes: str, robot: Context, found: RobotCover, formats: Formats, format: str, out: str | None
) -> int:
    """Write the shapes of a robot in a format, and print the table if it is a file.

    Returns:
        The exit code.
    """
    with working():
        text = _text(robot, found, formats, format)
        lines = [] if out is None else list(_table(shapes, found))
    if out is None:
        output.write(text)
    else:
        atomic.write(out, output.encode(text))
        output.page([*lines, f"wrote {shown(out)}"])
    return int(bool(found.left_out))


def _text(robot: Context, found: RobotCover, formats: Formats, format: str) -> str:
    if format == "json":
        from urdfkit.core.strict_json import dumped

        return dumped(found.facts)
    return formats[format](robot, found)


def _table(shapes: str, found: RobotCover) -> Iterator[str]:
    """The table, and the replaced or omitted geometry."""
    head = ("link", shapes, "coverage", "surface", "sticks out: mean", "p95", "max")
    rows: list[tuple[str, ...]] = [head]
    rows += [_row(link.link, link.quality) for link in found.links]
    yield from tables.columns([*rows, _row("total", found.total)])
    for note in (*found.replaced, *found.left_out):
        yield from output.indented(note, first="")


def _row(name: str, quality: CoverQuality) -> tuple[str, ...]:
    shares = (f"{100 * x:.1f} %" for x in (quality.coverage, quality.surface_coverage))
    protrusions = (quality.protrusion_mean, quality.protrusion_p95, quality.protrusion_max)
    return (name, str(quality.number), *shares, *map(tables.length, protrusions))
