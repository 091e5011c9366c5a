"""Commands that a Python launch file joins from pieces without spaces."""

import ast
import os
import re

from urdfkit.core import disk
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


def missing_program(values: Values, command: ast.expr | None, text: str) -> Problem | None:
    """A ``Command`` that runs the description itself, which is no program, instead of xacro."""
    path = text.strip().split(" ")[0]
    if command is None or not path.lower().endswith((".xacro", ".urdf")):
        return None
    if disk.is_file(path) and disk.state(path).st_mode & 0o111:
        return None
    message = f"'{os.path.basename(path)}' is run as a program: 'xacro ' is missing before it"
    return values.problem("LAU036", command, message, "write 'xacro ' with a space")


def _text(values: Values, piece: ast.expr | None) -> str:
    """The text of a piece: a word for a substitution, a space if it is unknown."""
    text = values.text(piece)
    if text is not None:
        return text or " "
    return "x" if isinstance(values.resolved(piece), ast.Call) else " "
