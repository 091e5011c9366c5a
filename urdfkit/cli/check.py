"""``urdfkit check`` as a click command."""

from typing import Any

import click

from urdfkit.cli.checking import run_check
from urdfkit.cli.decorators import click_option, described
from urdfkit.cli.options import CHECK, FILES


@described("check")
@click.argument(FILES, nargs=-1, metavar="FILE... [NAME:=VALUE]...")
def command(**values: Any) -> int:
    """Check robot models; report problems at their source lines.

    FILE is a URDF or xacro file, or a directory; '-' is standard input.
    NAME:=VALUE is a xacro argument.

    Exit codes: 0 no findings at or above --fail-on, 1 findings, 2 usage or input error,
    3 internal error (a bug in urdfkit).

    Examples:
        urdfkit check robot.urdf.xacro prefix:=left_
        urdfkit check . --fail-on error --format text --format sarif:robots.sarif
        xacro robot.urdf.xacro | urdfkit check -
    """
    return run_check(values)


command.params += map(click_option, CHECK)
