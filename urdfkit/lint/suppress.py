"""Suppression of findings by ignore comments."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfkit.core.grouping import by_key
from urdfkit.core.nested_intervals import NestedIntervals
from urdfkit.core.record import Record
from urdfkit.lint.ignore_comments import Ignore
from urdfkit.lint.rule_index import redirect
from urdfkit.text.diagnostic import Call, Diagnostic, Severity
from urdfkit.text.source import Span


class SuppressionResult(Record):
    """Findings after suppression."""

    kept: tuple[Diagnostic, ...]  # remaining findings, with their remaining macro calls
    hits: frozenset[Span]  # comments that suppressed a finding or call


def apply_suppressions(
    diagnostics: Iterable[Diagnostic], comments: Sequence[Ignore]
) -> SuppressionResult:
    """Remove the findings, or their single macro calls, that comments suppress."""
    kept: list[Diagnostic] = []
    hits: set[Span] = set()
    known: dict[tuple[str, str, Severity], CommentIndex] = {}  # the comments that name a rule
    for diagnostic in diagnostics:
        key = (diagnostic.code, diagnostic.name, diagnostic.severity)
        if key not in known:
            known[key] = CommentIndex(c for c in comments if _names(c, diagnostic))
        naming = known[key]
        at_place = naming.covering(diagnostic.span)
        hits.update(comment.span for comment in at_place)
        calls = [] if at_place else _remaining(diagnostic, naming, hits)
        if calls and len(calls) == len(diagnostic.calls):
            kept.append(diagnostic)
        elif calls:
            kept.append(diagnostic._replace(calls=tuple(calls), message=calls[0].message))
    return SuppressionResult(tuple(kept), frozenset(hits))


def _names(comment: Ignore, diagnostic: Diagnostic) -> bool:
    """True if a comment contains the rule of a finding.

    A former rule was merged with others, whose errors the comment is not meant to suppress.
    """
    is_error = diagnostic.severity is Severity.ERROR
    return any(
        diagnostic.code.startswith(code.upper())
        or diagnostic.name == code
        or (not is_error and diagnostic.code == redirect(code))
        for code, _ in comment.codes
    )


def _remaining(diagnostic: Diagnostic, naming: CommentIndex, hits: set[Span]) -> list[Call]:
    """The calls of a finding that no comment suppresses."""
    remaining: list[Call] = []
    for call in diagnostic.calls:
        at_call = [comment for step in call.via for comment in naming.covering(step.span)]
        hits.update(comment.span for comment in at_call)
        if not at_call:
            remaining.append(call)
    return remaining


class CommentIndex:
    """Search of ignore comments by place: a file may have thousands of them."""

    def __init__(self, comments: Iterable[Ignore]) -> None:
        by_source = by_key((id(comment.span.source), comment) for comment in comments)
        self._by_source = {
            key: NestedIntervals((comment.start, comment.end, comment) for comment in group)
            for key, group in by_source.items()
        }

    def covering(self, span: Span) -> list[Ignore]:
        """The comments that apply to the elements around a place."""
        nested = self._by_source.get(id(span.source))
        return nested.around(span.start) if nested else []
