"""``urdfkit collisions``: which links of a robot can collide with one another."""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING, Any

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import SEED, described, in_formats, limited, option
from urdfkit.cli.posing import posed, positions
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core import atomic
from urdfkit.core.strict_json import dumped
from urdfkit.text.editing import rewriting
from urdfkit.text.source import Source
from urdfkit.text.source import shown as shown_path

if TYPE_CHECKING:
    from urdfkit.physics.collision.matrix import Matrix


@described("collisions")
@one_robot
@posed
@option("--samples N", "Sampled configurations.", type=click.IntRange(0), default=10_000)
@SEED
@option("--jobs N", "Processes. [default: one per processor]", type=click.IntRange(1))
@option("-o, --output FILE", "SRDF to write, or to update; '-' prints only the SRDF.", to="srdf")
@option("--compare FILE", "Compare with the matrix of this SRDF.")
@click.option(
    "--units",
    type=click.Choice(["applied", "ignored"]),
    help="Whether the <unit> of a COLLADA mesh is applied. [default: as the targets do]",
)
@in_formats("text", "json", "markdown")
@limited
def command(
    inputs: dict[str, Any],
    srdf: str | None,
    compare: str | None,
    units: str | None,
    format: str,
    **sampling: Any,
) -> int:
    """Compute which links of a robot can collide with one another.

    Samples configurations within the joint limits and classifies the pairs of links as MoveIt's
    Setup Assistant does: adjacent, default, always, sometimes or never. The initial pose has all
    joints at 0 unless --joint or --pose is given.

    Exit codes: 0 done, 1 the SRDF of --compare disables a collision that can happen, 2 usage or
    input error.

    Examples:
        urdfkit collisions robot.urdf.xacro -o robot.srdf
        urdfkit collisions robot.urdf.xacro --compare robot.srdf
    """
    context = robot(inputs)
    start = positions(context, inputs)
    from urdfkit.ros.moveit.srdf_reader import read_named

    srdf_to_compare = read_named(compare, context) if compare else None
    for_moveit = bool(srdf or compare)  # MoveIt ignores units
    applied = units == "applied" if units else (False if for_moveit else None)
    with progress_bar() as bar:
        matrix = context.collisions.matrix(begin=start, units=applied, progress=bar, **sampling)
    from urdfkit.cli.collisions import shown
    from urdfkit.physics.collision.srdf_matrix import compare as compared

    comparison = compared(matrix, srdf_to_compare) if srdf_to_compare else None
    if srdf == "-":
        from urdfkit.physics.collision.srdf_matrix import new_srdf

        text = new_srdf(matrix).decode()
    elif format == "json":
        text = dumped(shown.as_json(matrix, comparison))
    else:
        text = (shown.markdown if format == "markdown" else shown.text)(matrix, comparison)
    output.write(text)
    if srdf and srdf != "-":
        _write(matrix, srdf)
    return 1 if comparison and comparison.hidden else 0


def _write(matrix: Matrix, path: str) -> None:
    """Write the SRDF, or update the existing one."""
    from urdfkit.physics.collision.srdf_matrix import new_srdf, srdf_edits

    if exists := os.path.exists(path):
        rewriting.write(rewriting.rewrites(srdf_edits(matrix, Source.read(path))))
    else:
        atomic.write(path, new_srdf(matrix))
    print(f"{'updated' if exists else 'wrote'} {shown_path(path)}", file=sys.stderr)
