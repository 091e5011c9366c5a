"""``urdfkit lsp``: the language server for editors."""

from urdfkit.cli.decorators import described, option
from urdfkit.core.installation import needing


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
    with needing("urdfkit lsp", "lsp"):
        from urdfkit.lsp.features import make
        from urdfkit.lsp.server import serve
    serve(make())
    return 0
