"""The report as a JSON document; ``report.schema.json`` is its schema.

Lines and columns count from 1, columns in characters; an end is the position after the last
character. Equal reports yield equal bytes.
"""

import json
from collections.abc import Iterator
from typing import Any

from urdfkit import __version__
from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import posix
from urdfkit.text.diagnostic import Call, Diagnostic, Fix, Severity
from urdfkit.text.document import Step
from urdfkit.text.source import Span

#: Version of the document; an incompatible change increments it.
VERSION = 2


def stream(report: Report, *, color: bool = False, width: int = 80) -> Iterator[str]:
    """The whole report."""
    before, empty, after = _dumped(without_findings(report)).partition("[]")
    yield before
    between, end = "[\n    ", empty
    for diagnostic in report.diagnostics:
        yield between + _dumped(finding(diagnostic)).replace("\n", "\n    ")
        between, end = ",\n    ", "\n  ]"
    yield f"{end}{after}\n"


def without_findings(report: Report) -> dict[str, Any]:
    """The document as plain values; its list of findings is empty."""
    return {
        "version": VERSION,
        "urdfkit": __version__,
        "diagnostics": [],
        "launched": [
            {"path": posix(item.path), "launch": posix(item.launch), "arguments": item.arguments}
            for item in report.launched
        ],
        "skipped": [
            {"code": skip.code, "path": posix(skip.path), "reason": skip.reason}
            for skip in sorted(report.skipped)
        ],
        "crashed": [
            {"code": crash.code, "path": posix(crash.path), "error": crash.error}
            for crash in sorted(report.crashed)
        ],
        "summary": _summary(report),
    }


def _dumped(content: dict[str, Any]) -> str:
    return json.dumps(content, ensure_ascii=False, indent=2)


def finding(diagnostic: Diagnostic) -> dict[str, Any]:
    """A finding as plain values."""
    return {
        "code": diagnostic.code,
        "name": diagnostic.name,
        "severity": diagnostic.severity.value,
        "confidence": diagnostic.confidence.value,
        "targets": list(diagnostic.targets),
        "variants": list(diagnostic.variants),
        "message": diagnostic.message,
        **_place(diagnostic.span),
        "element": diagnostic.element,
        "calls": [_call(call) for call in diagnostic.calls],
        "related": [
            {"message": related.message, **_place(related.span)} for related in diagnostic.related
        ],
        "help": diagnostic.help,
        "fix": _fix(diagnostic.fix) if diagnostic.fix else None,
    }


def _place(span: Span) -> dict[str, Any]:
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {
        "path": posix(span.source.path),
        "line": line,
        "column": column,
        "end_line": end_line,
        "end_column": end_column,
    }


def _call(call: Call) -> dict[str, Any]:
    via = [_step(step) for step in call.via]
    return {"message": call.message, "element": call.element, "via": via}


def _step(step: Step) -> dict[str, Any]:
    name = step.name if step.kind == "macro" else posix(step.name)
    return {"kind": step.kind, "name": name, **_place(step.span)}


def _fix(fix: Fix) -> dict[str, Any]:
    edits = [{**_place(edit.span), "text": edit.text} for edit in fix.edits]
    return {"title": fix.title, "safe": fix.safe, "edits": edits}


def _summary(report: Report) -> dict[str, Any]:
    codes: dict[str, int] = {}
    for diagnostic in report.diagnostics:
        codes[diagnostic.code] = codes.get(diagnostic.code, 0) + 1
    return {
        "files": [posix(path) for path in report.files],
        "rules": list(report.rules),
        "targets": [
            {"path": posix(path), "names": list(targets.names), "evidence": list(targets.evidence)}
            for path, targets in report.targets
        ],
        "error": report.count(Severity.ERROR),
        "warning": report.count(Severity.WARNING),
        "info": report.count(Severity.INFO),
        "suppressed": report.suppressed,
        "tolerated": report.tolerated,
        "codes": dict(sorted(codes.items())),
    }
