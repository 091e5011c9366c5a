"""Ignore comments in a model, for findings that its authors accept.

``<!-- urdfkit: ignore[INE006, MSH] reason -->`` applies to the next element and its descendants.
Before the root element it applies to the whole file. A finding in a macro is suppressed for all
calls by a comment in the macro, and for one call by a comment at the call.
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

#: Without brackets it ignores nothing, which CFG001 reports.
_IGNORE = re.compile(rb"(?s)\s*urdfkit\s*:\s*ignore\b\s*(?:\[([^\]]*)\])?(.*)")
_CODE = re.compile(rb"[A-Za-z0-9_-]+")


class Ignore(Record):
    """One ignore comment."""

    span: Span  # span of the comment
    #: Codes, prefixes of codes, or names, as written; empty if the comment is incomplete.
    codes: tuple[tuple[str, Span], ...]
    reason: str  # as written
    start: int  # first byte of the source that it applies to
    end: int  # end of these bytes


def ignores(source: Source) -> tuple[Ignore, ...]:
    """The ignore comments of a file; empty if the file is not well formed."""
    if b"urdfkit" not in source.data:
        return ()
    matches = [
        (Span(source, *comment.span()), match)
        for comment in comments(source.data)
        if (match := _IGNORE.fullmatch(source.data, *comment.span(1)))
    ]
    if not matches:
        return ()
    elements = _elements(source)
    ignores = []
    for span, match in matches:
        following = bisect_left(elements, (span.end,))
        if following < len(elements):
            found = _CODE.finditer(source.data, *match.span(1)) if match[1] else ()
            codes = tuple((code.group().decode(), Span(source, *code.span())) for code in found)
            reason = match.group(2).strip().decode("utf-8", "replace")
            ignores.append(Ignore(span, codes, reason, *elements[following]))
    return tuple(ignores)


class CommentPlaces:
    """Places for ignore comments in a file.

    Args:
        source: XML file; if it is not well formed, there are no places.
    """

    def __init__(self, source: Source) -> None:
        self._source = source
        elements = _elements(source)
        self.has_root = bool(elements)
        self._elements = elements[1:]  # a comment before the root applies to the whole file
        self._known = {comment.start: comment for comment in ignores(source) if comment.codes}

    def element(self, offset: int) -> int | None:
        """The first byte of the innermost element around a place; None if that is the root."""
        around = [start for start, end in self._elements if start <= offset < end]
        return around[-1] if around else None

    def edit(self, start: int, codes: Iterable[str]) -> Edit:
        """An edit that ignores rules in the element at a byte, in its comment if it has one."""
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
