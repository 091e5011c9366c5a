"""``urdfkit convert``: a robot in the format of another program, with the losses."""

from collections.abc import Iterator
from typing import Any

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import OUT, choice, described, in_formats, limited, option
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core.words import counted
from urdfkit.output.conversion import convert
from urdfkit.output.conversion.formats import FORMATS
from urdfkit.output.conversion.losses import Result
from urdfkit.output.conversion.options import BASES, COLLISIONS, EXCLUSIONS, FIXED
from urdfkit.output.conversion.result import Conversion
from urdfkit.text.source import shown


@described("convert")
@one_robot
@click.option("--to", type=click.Choice(list(FORMATS)), required=True, help="Format to write.")
@OUT
@choice("--base", of=BASES, help="Weld the root to the world, or let it float.")
@choice(
    "--fixed", of=FIXED, help="Give links of fixed joints bodies, or merge them into their parents."
)
@choice("--collision", of=COLLISIONS, help="Replacement of collision meshes.")
@choice(
    "--exclude",
    of=EXCLUSIONS,
    help="Pairs of links that do not collide: disabled in the SRDF, or also computed.",
)
@option("--force", "Replace OUT if it is a conversion.")
@in_formats("text", "json")
@limited
def command(inputs: dict[str, Any], to: str, out: str, format: str, **options: Any) -> int:
    """Convert a robot to another format, with meshes and a proof.

    MJCF for MuJoCo, USD for Isaac Sim and Newton, SDF for Gazebo, or URDF without xacro. OUT
    contains the model, its meshes, and conversion.json with the result for every element and
    attribute. The output is read again and compared with the robot.

    Exit codes: 0 done, 2 the robot cannot be converted, or OUT cannot be written.

    Examples:
        urdfkit convert robot.urdf.xacro --to mjcf -o robot_mjcf
        urdfkit convert robot.urdf.xacro --to usd -o robot_usd
        urdfkit convert robot.urdf.xacro --to sdf -o models/robot
        urdfkit convert robot.urdf.xacro --to mjcf -o robot.zip --fixed merge
        urdfkit convert robot.urdf.xacro --to mjcf -o arm --collision primitives
    """
    with progress_bar() as bar:
        context = robot(inputs, bar)
    conversion = convert(context, out, to=to, **options)
    output.json_or_page(format, lambda: conversion.facts, _page(conversion, out))
    return 0


def _page(conversion: Conversion, out: str) -> Iterator[str]:
    root = {"free": "; its root floats", "fixed": "; its root is welded to the world", "": ""}
    yield f"wrote {shown(out)}: {conversion.file}{root[conversion.root]}"
    counts = (counted(number, thing) for thing, number in conversion.counts.items() if number)
    yield from output.indented(", ".join(counts))
    yield from output.indented(conversion.proof.agreed)
    links = [
        entry.result
        for entry in conversion.entries
        if entry.tag == "<link>" and entry.part.startswith("link/")
    ]
    if lost := links.count(Result.LOST):
        yield from output.indented(f"lost {lost} of {counted(len(links), 'link')}: see below")
    for result in (Result.APPROXIMATED, Result.LOST):
        parts = list(conversion.grouped(result))
        if parts:
            yield f"{result.value}:"
        for note, entries in parts:
            tags = dict.fromkeys(entry.tag for entry in entries)
            first = entries[0]
            more = f", and {counted(len(entries) - 1, 'more place')}" if entries[1:] else ""
            yield from output.indented(f"{', '.join(tags)}: {note} ({first.span}{more})")
