"""``urdfkit report``: all that is known of a robot, as one file."""

from __future__ import annotations

from typing import Any

import click

from urdfkit import atomic
from urdfkit.cli import options, output, stdin
from urdfkit.cli.epilog import examples
from urdfkit.cli.progress import shown
from urdfkit.cli.robot import judged, only_file
from urdfkit.diagnostic import Severity
from urdfkit.page.csv import COLUMNS
from urdfkit.page.words import LANGUAGES
from urdfkit.page.writing import form_of, report


@click.command(
    "report",
    epilog=examples(
        "urdfkit report robot.urdf.xacro -o robot.html",
        "urdfkit report robot.urdf.xacro -o masses.csv --table links",
    ),
)
@judged()
@click.option(
    "-o", "--output", "output_file", metavar="FILE", help="Write .html, .md, .json or .csv to FILE."
)
@click.option("--lang", type=click.Choice(LANGUAGES), default="en", help="Language of the page.")
@click.option("--quick", is_flag=True, help="Without pictures, statics and collisions.")
@click.option("--table", type=click.Choice([*COLUMNS]), default="findings", help="Of a .csv.")
@click.option("--fail-on", type=click.Choice(["error", "warning", "info"]), help="Exit with 1.")
def command(
    output_file: str | None,
    lang: str,
    quick: bool,
    table: str,
    fail_on: str | None,
    **values: Any,
) -> int:
    """Write all that is known of a robot to one file.

    The HTML opens offline: findings with their source, the robot in 3D with a slider for each
    joint, masses, joints, meshes, and what Gazebo makes of it. Without -o, Markdown goes to
    standard output.

    Exit codes: 0 done, 1 findings of the severity of --fail-on or worse, 2 it cannot be done.
    """
    file = only_file(values)
    with shown() as bar:
        text, document = report(
            stdin.opened(file),
            form_of(output_file) if output_file else "markdown",
            language=lang,
            table=table,
            quick=quick,
            arguments=options.arguments(values),
            packages=options.packages(values),
            targets=options.words(values, "target"),
            trust=values["trust"],
            config=options.config(values, file),
            progress=bar,
        )
    if output_file:
        atomic.write(output_file, output.encode(text))
    else:
        output.write(text)
    if fail_on is None:
        return 0
    worst = [one for one in Severity if one.rank <= Severity(fail_on).rank]
    return int(any(document["summary"][severity.value] for severity in worst))
