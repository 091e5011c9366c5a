"""Ignore comments in a model: findings that its authors have seen and accept.

``<!-- urdfkit: ignore[INE006, MSH] reason -->`` holds for the element that follows it, with
everything in it. Before the root element it holds for the whole file. A finding in a macro is
suppressed for all calls by a comment in the macro, and for one call by a comment at the call.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable

from urdfkit.core.record import Record
from urdfkit.text.comments import comments
from urdfkit.text.diagnostic import Edit
from urdfkit.text.editing.edits import indent_of, newline
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml

_IGNORE = re.compile(rb"\s*urdfkit\s*:\s*ignore\s*\[([^\]]*)\](.*)", re.DOTALL)
_CODE = re.compile(rb"[A-Za-z0-9_-]+")


class Ignore(Record):
    """One ignore comment."""

    span: Span  # of the comment
    #: As written, each with its place; beginnings of codes and names count too.
    codes: tuple[tuple[str, Span], ...]
    reason: str  # as written
    #: start and end: bytes of the source that it holds for.
    start: int
    end: int


def ignores(source: Source) -> tuple[Ignore, ...]:
    """The ignore comments of a file; none of a file that is not well formed."""
    if b"urdfkit" not in source.data:
        return ()
    found_comments = [
        (Span(source, *comment.span()), said)
        for comment in comments(source.data)
        if (said := _IGNORE.fullmatch(source.data, *comment.span(1)))
    ]
    if not found_comments:
        return ()
    elements = _elements(source)
    found = []
    for span, said in found_comments:
        following = bisect_left(elements, (span.end,))
        if following < len(elements):
            codes = tuple(
                (code.group().decode(), Span(source, *code.span()))
                for code in _CODE.finditer(source.data, *said.span(1))
            )
            reason = said.group(2).strip().decode("utf-8", "replace")
            found.append(Ignore(span, codes, reason, *elements[following]))
    return tuple(found)


class CommentPlaces:
    """Where ignore comments can stand in a file.

    Args:
        source: of XML; in another one, or one that is not well formed, they stand nowhere.
    """

    def __init__(self, source: Source) -> None:
        self._source = source
        elements = _elements(source)
        self.has_root = bool(elements)
        self._elements = elements[1:]  # before the root it would be for the whole file
        self._known = {comment.start: comment for comment in ignores(source) if comment.codes}

    def element(self, offset: int) -> int | None:
        """The first byte of the innermost element around a place; None if that is the root."""
        around = [start for start, end in self._elements if start <= offset < end]
        return around[-1] if around else None

    def edit(self, start: int, codes: Iterable[str]) -> Edit:
        """Ignore rules in the element that begins at a byte, in its comment if it has one."""
        if known := self._known.get(start):
            end = known.codes[-1][1].end
            return Edit(Span(self._source, end, end), "".join(f", {code}" for code in codes))
        span = Span(self._source, start, start)
        indent = indent_of(span)
        separator = " " if indent is None else newline(self._source) + indent
        return Edit(span, f"<!-- urdfkit: ignore[{', '.join(codes)}] -->{separator}")


def _elements(source: Source) -> list[tuple[int, int]]:
    """First and last byte of every element, in the order of their start tags."""
    document, _ = read_xml(source)
    if document is None:
        return []
    return [element.tag_at.whole_span[1:] for element in document.root.walk()]
