"""Findings for a page: with their source excerpt, and their links and joints."""

from collections.abc import Iterable
from typing import Any

from urdfkit.lint import rule_index
from urdfkit.output.formats import json as as_json
from urdfkit.robot.element_lookup import ElementLookup
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Span
from urdfkit.text.terminal import printable

#: Lines shown before and after the line of a finding.
CONTEXT = 1
#: Most characters that are shown on either side of the marked text, and of the marked text.
MAX_SIDE, MAX_MARKED = 80, 240
_MORE = "..."


def findings(diagnostics: Iterable[Diagnostic], places: ElementLookup) -> list[dict[str, Any]]:
    """The findings as in the JSON report, with additional entries for a page."""
    return [
        {
            **_written(finding),
            "family": rule_index.FAMILIES.get(finding.code[:3], finding.code[:3]),
            "links": _unique(places.link(call.element) for call in finding.calls),
            "joints": _unique(places.joint(call.element) for call in finding.calls),
            "excerpt": excerpt(finding.span),
            "explanation": rule_index.get(finding.code).explanation,
        }
        for finding in diagnostics
    ]


def _written(finding: Diagnostic) -> dict[str, Any]:
    entry = as_json.finding(finding)
    del entry["variants"]  # a report covers one variant
    return entry


def _unique(names: Any) -> list[str]:
    return list(dict.fromkeys(name for name in names if name))


def excerpt(span: Span) -> list[dict[str, Any]]:
    """The line of a span and its neighbours, as text before, in and after the span."""
    source, line = span.source, span.line
    last = source.position(len(source.data))[0]
    shown = range(max(1, line - CONTEXT), min(last, line + CONTEXT) + 1)
    return [_marked(span) if number == line else _plain(span, number) for number in shown]


def _plain(span: Span, number: int) -> dict[str, Any]:
    text = _shown(span.source.line(number))
    if len(text) > MAX_MARKED:
        text = text[:MAX_MARKED] + _MORE
    return {"line": number, "before": text, "marked": "", "after": ""}


def _marked(span: Span) -> dict[str, Any]:
    data = span.source.data
    begin, end = span.source.line_bounds(span.line)
    before, marked, after = (
        _shown(data[start:stop].decode("utf-8", "replace").rstrip("\r\n"))
        for start, stop in (
            (max(begin, span.start - 4 * MAX_SIDE), span.start),
            (span.start, min(span.end, end, span.start + 4 * MAX_MARKED)),
            (max(span.start, min(span.end, end)), min(end, span.end + 4 * MAX_SIDE)),
        )
    )
    if len(before) > MAX_SIDE:
        before = _MORE + before[-MAX_SIDE:]
    if len(marked) > MAX_MARKED:
        marked = marked[:MAX_MARKED] + _MORE
    if len(after) > MAX_SIDE:
        after = after[:MAX_SIDE] + _MORE
    return {"line": span.line, "before": before, "marked": marked, "after": after}


def _shown(text: str) -> str:
    return printable(text.replace("\t", "    "))
