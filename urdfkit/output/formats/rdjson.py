"""reviewdog's JSON, for comments on pull requests, with fixes as suggestions.

Columns count bytes of UTF-8, ends are exclusive. Source of the format: the comments in reviewdog's
``reviewdog.proto``.
"""

import json
from typing import Any

from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import posix
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Source, Span


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """All findings as one document."""
    document = {
        "source": {"name": "urdfkit"},
        "diagnostics": [_diagnostic(d) for d in report.diagnostics],
    }
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _diagnostic(diagnostic: Diagnostic) -> dict[str, Any]:
    span = diagnostic.span
    entry: dict[str, Any] = {
        "message": diagnostic.text,
        "location": {"path": posix(span.source.path), "range": _range(span)},
        "severity": diagnostic.severity.value.upper(),
        "code": {"value": diagnostic.code},
    }
    if suggestions := _suggestions(diagnostic):
        entry["suggestions"] = suggestions
    return entry


def _suggestions(diagnostic: Diagnostic) -> list[dict[str, Any]]:
    """The edits of a fix; empty if an edit is in another file, which a suggestion cannot change."""
    edits = diagnostic.fix.edits if diagnostic.fix else ()
    if any(edit.span.source is not diagnostic.span.source for edit in edits):
        return []
    return [{"range": _range(edit.span), "text": edit.text} for edit in edits]


def _range(span: Span) -> dict[str, dict[str, int]]:
    return {"start": _position(span.source, span.start), "end": _position(span.source, span.end)}


def _position(source: Source, offset: int) -> dict[str, int]:
    line, column = source.position(offset)
    before = source.line(line)[: column - 1]
    return {"line": line, "column": len(before.encode("utf-8", "surrogatepass")) + 1}
