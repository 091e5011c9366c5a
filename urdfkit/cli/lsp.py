"""``urdfkit lsp``: the language server for editors."""

from urdfkit.cli.decorators import described, option
from urdfkit.core.installation import install_command
from urdfkit.errors import MissingLibrary


@described("lsp")
@option("--stdio", "Communicate over standard input and output, which is the default.")
def command(stdio: bool) -> int:
    """Start the language server for editors.

    Editors start it themselves and communicate over standard input and output. It needs the extra
    [lsp].

    Exit codes: 0 the editor has disconnected, 2 the extra is not installed.

    Examples:
        urdfkit lsp --stdio
    """
    try:
        from urdfkit.lsp.features import make
        from urdfkit.lsp.server import serve
    except ModuleNotFoundError as error:
        if error.name not in ("lsprotocol", "pygls"):
            raise
        raise MissingLibrary(f"urdfkit lsp needs pygls: {install_command('lsp')}") from error
    serve(make())
    return 0
