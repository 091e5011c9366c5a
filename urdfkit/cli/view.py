"""``urdfkit view``: a robot in the browser, as it is being written."""

from __future__ import annotations

import sys
import webbrowser

import click

from urdfkit.cli import options
from urdfkit.page.server import serve
from urdfkit.page.state import Wish
from urdfkit.page.words import LANGUAGES, Words


@click.command("view")
@click.argument("words", nargs=-1, required=True, metavar="FILE [NAME:=VALUE]...")
@click.option("--port", type=click.IntRange(0, 65535), default=0, help="[default: a free one]")
@click.option("--no-open", is_flag=True, help="Print the address; open no browser.")
@click.option("--lang", type=click.Choice(LANGUAGES), default="en", help="Language of the page.")
@click.option("--target", "targets", multiple=True, metavar="NAMES", help="Weigh findings for it.")
@click.option("--package", multiple=True, metavar="NAME=FOLDER", help="Where a ROS package is.")
@click.option("--config", metavar="FILE", help="The configuration. [default: the nearest one]")
@click.option("--isolated", is_flag=True, help="Take no configuration.")
@click.option("--trust", is_flag=True, help="Let the model run any expression, read any file.")
def command(
    words: tuple[str, ...],
    port: int,
    no_open: bool,
    lang: str,
    targets: tuple[str, ...],
    package: tuple[str, ...],
    config: str | None,
    isolated: bool,
    trust: bool,
) -> int:
    """Show a robot in the browser, and follow changes of its files.

    The page is that of urdfkit report, with the xacro arguments as inputs. The server listens on
    this machine only, at an address that nobody can guess. Ctrl-C ends it.

    Exit codes: 0 done, 2 it cannot be done.
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
        raise options.UsageError("view takes one file; xacro arguments are written name:=value")
    wish = Wish(
        files[0],
        options.arguments(values),
        options.packages(values),
        tuple(options.words(values, "target")),
        trust,
        options.config(values, files[0]),
    )

    def opened(address: str) -> None:
        print(f"{address}\nCtrl-C ends it.", file=sys.stderr)
        if not no_open:
            webbrowser.open(address)

    try:
        serve(wish, Words(lang), port=port, opened=opened)
    except KeyboardInterrupt:
        pass  # which is how it ends
    return 0
