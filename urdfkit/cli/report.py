"""``urdfkit report``: all that is known of a robot, as one file."""

from __future__ import annotations

import click

from urdfkit import atomic
from urdfkit.cli import options, output
from urdfkit.cli.progress import on_terminal
from urdfkit.diagnostic import Severity
from urdfkit.page.csv import COLUMNS
from urdfkit.page.words import LANGUAGES
from urdfkit.page.writing import form_of, report


@click.command("report")
@click.argument("words", nargs=-1, required=True, metavar="FILE [NAME:=VALUE]...")
@click.option("-o", "target", metavar="FILE", help="Write .html, .md, .json or .csv to FILE.")
@click.option("--lang", type=click.Choice(LANGUAGES), default="en", help="Language of the page.")
@click.option("--quick", is_flag=True, help="Without pictures, statics and collisions.")
@click.option("--table", type=click.Choice([*COLUMNS]), default="findings", help="Of a .csv.")
@click.option("--fail-on", type=click.Choice(["error", "warning", "info"]), help="Exit with 1.")
@click.option("--target", "targets", multiple=True, metavar="NAMES", help="Weigh findings for it.")
@click.option("--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is.")
@click.option("--config", metavar="FILE", help="The configuration. [default: the nearest one]")
@click.option("--isolated", is_flag=True, help="Take no configuration.")
@click.option("--trust", is_flag=True, help="Let the model run any expression, read any file.")
def command(
    words: tuple[str, ...],
    target: str | None,
    lang: str,
    quick: bool,
    table: str,
    fail_on: str | None,
    targets: tuple[str, ...],
    package: tuple[str, ...],
    config: str | None,
    isolated: bool,
    trust: bool,
) -> int:
    """Write all that is known of a robot to one file.

    The HTML opens offline: findings with their source, the robot in 3D with a slider for each
    joint, masses, joints, meshes, and what Gazebo makes of it. Without -o, Markdown goes to
    standard output.

    Exit codes: 0 done, 1 findings of the severity of --fail-on or worse, 2 it cannot be done.
    """
    values = {
        options.FILES: words,
        "package": package,
        "target": targets,
        "config": config,
        "isolated": isolated,
        "trust": trust,
    }
    files = options.files(values)
    if len(files) != 1:
        raise options.UsageError("report takes one file; xacro arguments are written name:=value")
    progress = on_terminal()
    try:
        text, document = report(
            files[0],
            form_of(target) if target else "markdown",
            language=lang,
            table=table,
            quick=quick,
            arguments=options.arguments(values),
            packages=options.packages(values),
            targets=options.words(values, "target"),
            trust=trust,
            config=options.config(values, files[0]),
            progress=progress,
        )
    finally:
        if progress:
            progress.wipe()
    if target:
        atomic.write(target, output.encode(text))
    else:
        output.write(text)
    if fail_on is None:
        return 0
    worst = [one for one in Severity if one.rank <= Severity(fail_on).rank]
    return int(any(document["summary"][severity.value] for severity in worst))
