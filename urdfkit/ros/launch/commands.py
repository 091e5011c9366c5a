"""Commands that a Python launch file joins from pieces without spaces."""

import ast
import re

from urdfkit.ros.launch.values import Values
from urdfkit.text.diagnostic import Problem

_ENDS_IN_XACRO = re.compile(r"(?:^|[\s/])xacro(?:\.py)?$")
_BEGINS_WITH_ARGUMENT = re.compile(r"[A-Za-z_]\w*:=")


def missing_space(values: Values, command: ast.expr | None) -> Problem | None:
    """The first two pieces of a ``Command`` without a space between them.

    launch joins the pieces as they are: ``["xacro", path]`` is ``xacro/home/...``.
    """
    before = " "
    is_first_word = True
    for piece in values.items(command):
        text = _text(values, piece)
        if piece is not None and not before[-1:].isspace() and not text[:1].isspace():
            if is_first_word and _ENDS_IN_XACRO.search(before):
                message = "missing space between 'xacro' and the file path"
                return values.problem("LAU036", piece, message, "write 'xacro ' with a space")
            if match := _BEGINS_WITH_ARGUMENT.match(text):
                word = match.group()
                message = f"missing space before '{word}'"
                return values.problem(
                    "LAU036", piece, message, f"write ' {word}' with a space before it"
                )
        is_first_word = is_first_word and re.search(r"\s", text) is None
        before = text
    return None


def _text(values: Values, piece: ast.expr | None) -> str:
    """The text of a piece: a word for a substitution, a space if it is unknown."""
    text = values.text(piece)
    if text is not None:
        return text or " "
    return "x" if isinstance(values.resolved(piece), ast.Call) else " "
