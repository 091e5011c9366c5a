"""Inlay hints: the values of expressions."""

from collections.abc import Iterator

from urdfkit.core.words import few
from urdfkit.lsp.markup import Markup
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.text.terminal import printable

#: Limits of the values of an attribute and of the characters of a hint.
MAX_VALUES, MAX_LETTERS = 3, 40


def inlay_hints(
    robot: OpenRobot, markup: Markup, start: int, end: int
) -> Iterator[tuple[int, str]]:
    """The values of attributes with expressions, one for each call of a macro.

    Args:
        start: first byte of the requested range.
        end: offset after its last byte.

    Yields:
        The offset of the byte after a hint, and its text.
    """
    for node in markup.nodes:
        if node.tag_end < start or end < node.start:
            continue
        for written in node.attributes:
            span = written.value_span
            if span is None or "$" not in written.value:
                continue
            values = [_short(value) for value in robot.names.expanded(node, written.name)]
            if values:
                text = printable(few(values, MAX_VALUES))
                dots = "..." * (len(text) > MAX_LETTERS)
                yield span.end + 1, text[:MAX_LETTERS] + dots


def _short(value: str) -> str:
    """A value with numbers of six digits."""
    return " ".join(map(_rounded, value.split()))


def _rounded(word: str) -> str:
    try:
        short = f"{float(word):.6g}"
    except ValueError:
        return word
    return min(word, short, key=len)
