"""``urdfkit simulate``: does a robot behave in MuJoCo?"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import in_formats, limited, with_examples
from urdfkit.cli.progress import shown as progress
from urdfkit.cli.robot import one_robot, robot
from urdfkit.output.conversion.options import BASES
from urdfkit.output.simulation import simulate

if TYPE_CHECKING:
    from urdfkit.output.simulation.verdicts import Simulation


@with_examples(
    "simulate",
    "urdfkit simulate robot.urdf.xacro",
    "urdfkit simulate robot.urdf.xacro --base free --format json",
)
@one_robot
@click.option(
    "--base",
    type=click.Choice(BASES),
    default="auto",
    help="Weld the root to the world, or let it stand on a floor.",
)
@in_formats("text", "json")
@limited
def command(asked: dict[str, Any], base: str, form: str) -> int:
    """Simulate a robot in MuJoCo; report what it should not do.

    Links that overlap at the start; a robot that gains energy or diverges when it is released;
    joints that give way though they are held with all of their effort.

    Exit codes: 0 it behaves, 1 it does not, 2 it cannot be simulated.
    """
    with progress() as bar:
        context = robot(asked, bar)
    found = simulate(context, base=base)
    output.json_or_page(form, found.facts, _page(found))
    return int(not found.passes)


def _page(found: Simulation) -> Iterator[str]:
    yield "its root stands on a floor" if found.is_free else "its root is welded to the world"
    for one in found.verdicts:
        where = f" ({one.span})" if one.span else ""
        word = "passes" if one.passes else "FAILS"
        yield from output.indented(f"{word} {one.test}: {one.message}{where}")
