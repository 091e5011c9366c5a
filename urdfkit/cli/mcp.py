"""``urdfkit mcp``: the tools of urdfkit for programs that speak the Model Context Protocol."""

import os

import click

from urdfkit.cli.decorators import described, option
from urdfkit.core.installation import needing
from urdfkit.errors import UnreadableFile


@described("mcp")
@click.argument("directory", default=os.curdir)
@option("--write", "Let the tool 'fix' write files.")
def command(directory: str, write: bool) -> int:
    """Offer check, explain, trace, expand, fix and render to agents.

    Uses the Model Context Protocol over standard input and output. The tools accept files below
    DIRECTORY, and change files only with --write. It needs the extra [mcp].

    Exit codes: 0 the client has disconnected, 2 usage error, or the extra is not installed.

    Examples:
        urdfkit mcp
        urdfkit mcp ~/robot_ws/src --write
    """
    if not os.path.isdir(directory):
        raise UnreadableFile(f"{directory}: no such directory")
    with needing("urdfkit mcp", "mcp"):
        from urdfkit.cli.mcp_tools import server
    server(directory, may_write=write).run("stdio")
    return 0
