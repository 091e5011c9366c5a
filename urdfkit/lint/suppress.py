"""Ignore comments in a model: findings that its authors have seen and accept.

``<!-- urdfkit: ignore[INE006, MSH] reason -->`` holds for the element that follows it, with
everything in it. Before the root element it holds for the whole file. A finding in a macro is
suppressed for all calls by a comment in the macro, and for one call by a comment at the call.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterable, Sequence

from urdfkit.core.libraries import load
from urdfkit.core.record import Record
from urdfkit.text.comments import comments
from urdfkit.text.diagnostic import Call, Diagnostic, Severity
from urdfkit.text.source import Source, Span
from urdfkit.text.xml_reader import read_xml

_IGNORE = re.compile(rb"\s*urdfkit\s*:\s*ignore\s*\[([^\]]*)\](.*)", re.DOTALL)
_CODE = re.compile(rb"[A-Za-z0-9_-]+")


class Ignore(Record):
    """One ignore comment.

    Attributes:
        span: of the comment.
        codes: as written, each with its place; beginnings of codes and names count too.
        reason: as written.
        start, end: bytes of the source that it holds for.
        redirected: codes of the rules that former codes and names stand for; their errors stay.
    """

    span: Span
    codes: tuple[tuple[str, Span], ...]
    reason: str
    start: int
    end: int
    redirected: tuple[str, ...] = ()

    def covers(self, span: Span) -> bool:
        """True if a place is in the element that the comment is about."""
        return span.source is self.span.source and self.start <= span.start < self.end

    def names(self, diagnostic: Diagnostic) -> bool:
        """True if the comment names the rule of a finding."""
        is_former = diagnostic.code in self.redirected
        # A former rule was merged with others, whose errors nobody wanted to suppress.
        return (is_former and diagnostic.severity is not Severity.ERROR) or any(
            diagnostic.code.startswith(code.upper()) or diagnostic.name == code
            for code, _ in self.codes
        )


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
            redirect = load("urdfkit.lint.rules").redirect  # which types import the other way
            redirected = tuple(filter(None, (redirect(word) for word, _ in codes)))
            found.append(Ignore(span, codes, reason, *elements[following], redirected))
    return tuple(found)


def _elements(source: Source) -> list[tuple[int, int]]:
    """First and last byte of every element, in the order of their start tags."""
    document, _ = read_xml(source)
    if document is None:
        return []
    return [element.tag_at.whole_span[1:] for element in document.root.walk()]


class SuppressionResult(Record):
    """Findings after suppression.

    Attributes:
        kept: what remains, with the calls that remain.
        suppressed: how many findings were suppressed wholly.
        hits: the comments that suppressed something.
    """

    kept: tuple[Diagnostic, ...]
    suppressed: int
    hits: frozenset[Span]


def sift(diagnostics: Iterable[Diagnostic], comments: Sequence[Ignore]) -> SuppressionResult:
    """Take out what comments suppress: whole findings, or single calls of a macro."""
    kept: list[Diagnostic] = []
    suppressed = 0
    hits: set[Span] = set()
    for diagnostic in diagnostics:
        naming = [comment for comment in comments if comment.names(diagnostic)]
        at_place = [comment for comment in naming if comment.covers(diagnostic.span)]
        hits.update(comment.span for comment in at_place)
        calls = [] if at_place else _remaining(diagnostic, naming, hits)
        if not calls:
            suppressed += 1
        elif len(calls) == len(diagnostic.calls):
            kept.append(diagnostic)
        else:
            kept.append(diagnostic._replace(calls=tuple(calls), message=calls[0].message))
    return SuppressionResult(tuple(kept), suppressed, frozenset(hits))


def _remaining(diagnostic: Diagnostic, naming: list[Ignore], hits: set[Span]) -> list[Call]:
    """The calls of a finding on whose way no comment stands."""
    remaining: list[Call] = []
    for call in diagnostic.calls:
        at_call = [c for c in naming if any(c.covers(step.span) for step in call.via)]
        hits.update(comment.span for comment in at_call)
        if not at_call:
            remaining.append(call)
    return remaining
