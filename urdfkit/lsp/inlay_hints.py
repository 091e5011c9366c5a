"""The values of expressions, for an editor to show behind them."""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.core.record import Record
from urdfkit.core.words import few
from urdfkit.lsp.markup import Page
from urdfkit.lsp.open_robot import OpenRobot
from urdfkit.text.terminal import printable

#: Values of one attribute and letters that are shown.
MAX_VALUES, MAX_LETTERS = 3, 40


class InlayHint(Record):
    """A text that an editor shows and the file does not hold."""

    offset: int  # of the byte that it stands before
    text: str


def inlay_hints(robot: OpenRobot, page: Page, start: int, end: int) -> Iterator[InlayHint]:
    """What attributes with expressions are after expansion: a value for each call of a macro.

    Args:
        start: first byte of the tags that are asked about.
        end: behind the last one.
    """
    for node in page.nodes:
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
                yield InlayHint(span.end + 1, text[:MAX_LETTERS] + dots)


def _short(value: str) -> str:
    """A value whose numbers have six digits, as people write them."""
    return " ".join(map(_rounded, value.split()))


def _rounded(word: str) -> str:
    try:
        short = f"{float(word):.6g}"
    except ValueError:
        return word
    return min(word, short, key=len)
