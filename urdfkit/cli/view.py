"""``urdfkit view``: a robot in the browser, reloaded when its files change."""

import sys
import webbrowser
from typing import Any

import click

from urdfkit.cli import options
from urdfkit.cli.decorators import choice, described, option
from urdfkit.cli.robot import only_file, with_robot_and_targets
from urdfkit.output.report.translations import LANGUAGES, Translator
from urdfkit.viewer.server import serve


@described("view")
@with_robot_and_targets()
@click.option(
    "--port",
    type=click.IntRange(0, 65535),
    default=0,
    show_default=False,
    help="Port of the server. [default: a free one]",
)
@option("--no-open", "Print the URL; do not open a browser.")
@choice("--lang", of=LANGUAGES, help="Language of the page.")
def command(port: int, no_open: bool, lang: str, **values: Any) -> int:
    """Show a robot in the browser; reload it when files change.

    The page is that of urdfkit report, with the xacro arguments as inputs. The server listens on
    this machine only, at an address with a random token. Ctrl-C stops it.

    Exit codes: 0 done, 2 usage or input error.

    Examples:
        urdfkit view robot.urdf.xacro prefix:=left_
    """
    file = only_file(values)
    if file == "-":
        raise options.UsageError("standard input cannot be watched; pass a file")

    def opened(address: str) -> None:
        print(f"{address}\nPress Ctrl-C to stop.", file=sys.stderr)
        if not no_open:
            webbrowser.open(address)

    try:
        serve(file, options.check_options(values, file), Translator(lang), port=port, opened=opened)
    except KeyboardInterrupt:
        pass  # Ctrl-C ends the server
    return 0
