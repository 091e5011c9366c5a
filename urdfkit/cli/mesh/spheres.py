"""``urdfkit mesh spheres``: spheres for motion planners in place of collision geometry."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import click

from urdfkit.cli import output
from urdfkit.cli.decorators import choice, described, limited, option, to_file
from urdfkit.cli.mesh import tables
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import one_robot, robot
from urdfkit.core import atomic
from urdfkit.output.spheres import RobotSpheres, fit_spheres
from urdfkit.output.spheres.planner_formats import FORMATS
from urdfkit.text.source import shown

if TYPE_CHECKING:
    from urdfkit.mesh.sphere_quality import SphereQuality


@described("spheres")
@one_robot
@to_file("out", "Write the spheres to this file.")
@choice(
    "--format",
    "format",
    of=[*FORMATS, "json"],
    help="Format of --output; json is the table with the spheres.",
)
@option("--most N", "Maximum number of spheres.", type=click.IntRange(1), default=100)
@option(
    "--margin METRES",
    "Approximate distance that a sphere may protrude, if --most allows it.",
    type=click.FloatRange(0, 1, min_open=True),
    default=0.01,
)
@option(
    "--coverage SHARE",
    "Share of the volume of each link that the spheres cover.",
    type=click.FloatRange(0, 1, min_open=True, max_open=True),
    default=0.99,
)
@option("--visual", "Cover the visual geometry.")
@limited
def command(inputs: dict[str, Any], out: str | None, format: str, **options: Any) -> int:
    """Cover the links of a robot with spheres, for motion planners.

    cuRobo's YAML and XRDF also list pairs of links that need no check for self-collision; URDF has
    spheres as collisions. The table is measured with samples that were not used for the fit.

    Exit codes: 0 done, 1 some geometry is omitted, 2 usage or input error.

    Examples:
        urdfkit mesh spheres robot.urdf.xacro -o robot.yml
        urdfkit mesh spheres robot.urdf.xacro --format xrdf -o robot.xrdf
        urdfkit mesh spheres robot.urdf --format urdf -o spheres.urdf --most 60
    """
    context = robot(inputs)
    with progress_bar() as bar:
        spheres = fit_spheres(context, progress=bar, **options)
    if format == "json":
        from urdfkit.core.strict_json import dumped

        text = dumped(spheres.facts)
    else:
        text = FORMATS[format](context, spheres)
    if out is None:
        output.write(text)
    else:
        atomic.write(out, output.encode(text))
        output.page([*render(spheres), f"wrote {shown(out)}"])
    return int(bool(spheres.left_out))


def render(spheres: RobotSpheres) -> Iterator[str]:
    """The table, and the replaced or omitted shapes."""
    head = ("link", "spheres", "coverage", "surface", "sticks out: mean", "p95", "max")
    rows: list[tuple[str, ...]] = [head]
    rows += [_row(link.link, link.quality) for link in spheres.links]
    yield from tables.columns([*rows, _row("total", spheres.total)])
    for note in (*spheres.replaced, *spheres.left_out):
        yield from output.indented(note, first="")


def _row(name: str, quality: SphereQuality) -> tuple[str, ...]:
    shares = (f"{100 * x:.1f} %" for x in (quality.coverage, quality.surface_coverage))
    protrusions = (quality.protrusion_mean, quality.protrusion_p95, quality.protrusion_max)
    return (name, str(quality.spheres), *shares, *map(tables.length, protrusions))
