"""``urdfkit report``: a report of a robot in one file."""

import os
from typing import Any

import click

from urdfkit.cli import options, output, stdin
from urdfkit.cli.decorators import choice, described, limited, option, to_file
from urdfkit.cli.progress import progress_bar
from urdfkit.cli.robot import only_file, with_robot_and_targets
from urdfkit.core import atomic
from urdfkit.output.report.csv import COLUMNS
from urdfkit.output.report.translations import LANGUAGES
from urdfkit.output.report.writing import form_of, report
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import shown


@described("report")
@with_robot_and_targets()
@to_file("output_file", "Write .html, .md, .json or .csv to FILE.")
@choice("--lang", of=LANGUAGES, help="Language of the page.")
@option("--quick", "Skip images, statics and collisions.")
@choice("--table", of=COLUMNS, help="Table of a .csv report.")
@option(
    "--fail-on SEVERITY",
    "Severity that makes the exit code 1.",
    type=click.Choice(["error", "warning", "info"]),
)
@limited
def command(
    output_file: str | None, lang: str, quick: bool, table: str, fail_on: str | None, **values: Any
) -> int:
    """Write a report of a robot to one file.

    The HTML opens offline: findings with their source lines, a 3D view with a slider for each
    joint, masses, joints, meshes, and the conversion for Gazebo. Without -o, writes Markdown to
    standard output.

    A robot with variants in the configuration gets a report for each: robot-NAME.html.

    Exit codes: 0 done, 1 findings at or above --fail-on, 2 usage or input error.

    Examples:
        urdfkit report robot.urdf.xacro -o robot.html
        urdfkit report robot.urdf.xacro -o masses.csv --table links
    """
    file, counts = only_file(values), dict.fromkeys(Severity, 0)
    settings, source = options.check_options(values, file), stdin.opened(file)
    variants = settings.config.entries(file, settings.arguments, settings.variant)
    for variant in variants:
        with progress_bar() as bar:
            text, document = report(
                source,
                form_of(output_file) if output_file else "markdown",
                settings._replace(variant=variant.name),
                language=lang,
                table=table,
                quick=quick,
                progress=bar,
            )
        if output_file:
            target = _of_variant(output_file, variant.name) if len(variants) > 1 else output_file
            atomic.write(target, output.encode(text))
            output.page([f"wrote {shown(target)}"])
        else:
            output.write(text)
        for severity in Severity:
            counts[severity] += document["summary"][severity.value]
    least = Severity(fail_on).rank if fail_on else -1
    return int(any(count for severity, count in counts.items() if severity.rank <= least))


def _of_variant(file: str, name: str) -> str:
    """The file for one of several variants: ``robot-left.html``."""
    stem, suffix = os.path.splitext(file)
    return f"{stem}-{name.replace(os.sep, '_').replace('/', '_')}{suffix}"
