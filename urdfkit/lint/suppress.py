"""Suppression: which findings ignore comments leave out."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from urdfkit.core.record import Record
from urdfkit.lint.ignore_comments import Ignore
from urdfkit.lint.rule_index import redirect
from urdfkit.text.diagnostic import Call, Diagnostic, Severity
from urdfkit.text.source import Span


class SuppressionResult(Record):
    """Findings after suppression."""

    kept: tuple[Diagnostic, ...]  # what remains, with the calls that remain
    suppressed: int  # how many findings were suppressed wholly
    hits: frozenset[Span]  # the comments that suppressed something


def apply_suppressions(
    diagnostics: Iterable[Diagnostic], comments: Sequence[Ignore]
) -> SuppressionResult:
    """Take out what comments suppress: whole findings, or single calls of a macro."""
    kept: list[Diagnostic] = []
    suppressed = 0
    hits: set[Span] = set()
    known: dict[tuple[str, str, Severity], list[Ignore]] = {}  # the comments that name a rule
    for diagnostic in diagnostics:
        key = (diagnostic.code, diagnostic.name, diagnostic.severity)
        if key not in known:
            known[key] = [comment for comment in comments if _names(comment, diagnostic)]
        naming = known[key]
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


def _names(comment: Ignore, diagnostic: Diagnostic) -> bool:
    """True if a comment names the rule of a finding.

    A former rule was merged with others, whose errors nobody wanted to suppress.
    """
    is_error = diagnostic.severity is Severity.ERROR
    return any(
        diagnostic.code.startswith(code.upper())
        or diagnostic.name == code
        or (not is_error and diagnostic.code == redirect(code))
        for code, _ in comment.codes
    )


def _remaining(diagnostic: Diagnostic, naming: list[Ignore], hits: set[Span]) -> list[Call]:
    """The calls of a finding on whose way no comment stands."""
    remaining: list[Call] = []
    for call in diagnostic.calls:
        at_call = [c for c in naming if any(c.covers(step.span) for step in call.via)]
        hits.update(comment.span for comment in at_call)
        if not at_call:
            remaining.append(call)
    return remaining
