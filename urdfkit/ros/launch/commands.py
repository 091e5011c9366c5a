"""Commands that a Python launch file puts together from pieces, with nothing between them."""

from __future__ import annotations

import ast
import re

from urdfkit.ros.launch.values import Values
from urdfkit.text.xml_reader import Problem

_ENDS_IN_XACRO = re.compile(r"(?:^|[\s/])xacro(?:\.py)?$")
_BEGINS_WITH_ARGUMENT = re.compile(r"[A-Za-z_]\w*:=")


def run_together(values: Values, command: ast.expr | None) -> Problem | None:
    """The first two pieces of a ``Command`` that become one word although two are meant.

    launch joins the pieces as they are: ``["xacro", path]`` is ``xacro/home/...``.
    """
    before = " "
    is_first_word = True
    for piece in values.items(command):
        text = _text(values, piece)
        if piece is not None and not before[-1:].isspace() and not text[:1].isspace():
            if is_first_word and _ENDS_IN_XACRO.search(before):
                message = "'xacro' and the file name become one word: nothing parts them"
                return Problem("LAU011", values.span(piece), message, "write 'xacro ' with a blank")
            if found := _BEGINS_WITH_ARGUMENT.match(text):
                word = found.group()
                message = f"'{word}' becomes part of the word before it: nothing parts them"
                help = f"write ' {word}' with a blank before it"
                return Problem("LAU011", values.span(piece), message, help)
        is_first_word = is_first_word and re.search(r"\s", text) is None
        before = text
    return None


def _text(values: Values, piece: ast.expr | None) -> str:
    """The text of a piece; of a substitution a word, and of what is unknown a blank."""
    text = values.text(piece)
    if text is not None:
        return text or " "
    return "x" if isinstance(values.suggested(piece), ast.Call) else " "
