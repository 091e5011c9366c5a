"""SARIF 2.1.0 for code scanning: every finding at its region in the source file.

The macro calls that led to a finding are related locations, the element after expansion is its
logical location, and edits elsewhere do not change the fingerprint. Columns count UTF-16
code units, as SARIF requires.
"""

import json
import os
from collections.abc import Iterable
from typing import Any

from urdfkit import __version__
from urdfkit.core.grouping import by_key
from urdfkit.lint import rule_index, rules
from urdfkit.lint.baseline import fingerprints
from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import in_repository, posix
from urdfkit.text.diagnostic import Call, Diagnostic, Edit, Fix, Severity
from urdfkit.text.source import Source, Span

_SCHEMA = "https://docs.oasis-open.org/sarif/sarif/v2.1.0/os/schemas/sarif-schema-2.1.0.json"
_LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
#: Most calls of a macro that become related locations.
_MAX_CALLS = 20


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """The whole report as one run."""
    ran = sorted({*report.rules, *(d.code for d in report.diagnostics)})
    numbers = {code: number for number, code in enumerate(ran)}
    marks = fingerprints(report.diagnostics)
    run = {
        "tool": {"driver": _driver(ran)},
        "columnKind": "utf16CodeUnits",
        "originalUriBaseIds": {
            "SRCROOT": {"description": {"text": "the repository, or where urdfkit was run"}}
        },
        "invocations": [_invocation(report)],
        "results": [
            _result(diagnostic, numbers[diagnostic.code], mark)
            for diagnostic, mark in zip(report.diagnostics, marks, strict=True)
        ],
    }
    document = {"$schema": _SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(document, ensure_ascii=False, indent=1) + "\n"


def _driver(codes: Iterable[str]) -> dict[str, Any]:
    return {
        "name": "urdfkit",
        "version": __version__,
        "semanticVersion": __version__,
        "rules": [_rule(rule_index.get(code)) for code in codes],
    }


def _rule(rule: rules.Rule) -> dict[str, Any]:
    summary, _, rest = rule.explanation.partition("\n")
    text = f"{rest.strip()}\n\n{rule.help}".strip()
    return {
        "id": rule.code,
        "name": "".join(word.capitalize() for word in rule.name.split("-")),
        "shortDescription": {"text": summary.strip()},
        "fullDescription": {"text": " ".join(rest.split()) or summary.strip()},
        "help": {"text": text or summary.strip()},
        "defaultConfiguration": {"level": _LEVELS[rule.severity]},
        "properties": {"tags": [rule.code[:3]]},
    }


def _invocation(report: Report) -> dict[str, Any]:
    unchecked = [item for item in report.diagnostics if item.code == rule_index.NOT_CHECKED]
    levels = {item.span.source.path: _LEVELS[item.severity] for item in unchecked}
    notes = [
        {
            "level": levels.get(skip.path, "note"),
            "message": {
                "text": f"{posix(skip.path)}: {skip.code or 'file'} skipped: {skip.reason}"
            },
        }
        for skip in report.skipped
    ]
    notes += [
        {
            "level": "error",
            "message": {"text": f"{posix(crash.path)}: {crash.code or 'check'}: {crash.error}"},
        }
        for crash in report.crashed
    ]
    return {"executionSuccessful": not report.crashed, "toolExecutionNotifications": notes}


def _result(diagnostic: Diagnostic, number: int, mark: str) -> dict[str, Any]:
    location: dict[str, Any] = _location(diagnostic.span)
    if diagnostic.element:
        location["logicalLocations"] = [
            {"fullyQualifiedName": diagnostic.element, "kind": "element"}
        ]
    result: dict[str, Any] = {
        "ruleId": diagnostic.code,
        "ruleIndex": number,
        "level": _LEVELS[diagnostic.severity],
        "message": {"text": diagnostic.text},
        "locations": [location],
        "partialFingerprints": {"urdfkit/v1": mark},
        "properties": {"confidence": diagnostic.confidence.value},
    }
    if diagnostic.variants:
        result["properties"]["variants"] = list(diagnostic.variants)
    if related := _related(diagnostic):
        result["relatedLocations"] = related
    if diagnostic.fix:
        result["fixes"] = [_fix(diagnostic.fix)]
    return result


def _related(diagnostic: Diagnostic) -> list[dict[str, Any]]:
    places = [(related.span, related.message) for related in diagnostic.related]
    for call in diagnostic.calls[:_MAX_CALLS]:
        places += _steps(call, several=len(diagnostic.calls) > 1)
    return [
        {"id": number, **_location(span), "message": {"text": message}}
        for number, (span, message) in enumerate(dict.fromkeys(places), 1)
    ]


def _steps(call: Call, *, several: bool) -> list[tuple[Span, str]]:
    """Expansion steps of a call, innermost first; with its message if there are several calls."""
    steps = []
    for step in reversed(call.via):
        verb = "included" if step.kind == "include" else f"expanded from {step.kind} '{step.name}'"
        steps.append((step.span, verb))
    if several and steps:
        steps[0] = (steps[0][0], call.message)
    return steps


def _location(span: Span) -> dict[str, Any]:
    return {
        "physicalLocation": {"artifactLocation": _artifact(span.source), "region": _region(span)}
    }


def _artifact(source: Source) -> dict[str, Any]:
    from urllib.parse import quote

    path = in_repository(source.path)
    if os.path.isabs(path):
        return {"uri": f"file://{'/' * (path[0] != '/')}" + quote(os.fsencode(path))}
    return {"uri": quote(os.fsencode(path)), "uriBaseId": "SRCROOT"}


def _region(span: Span) -> dict[str, int]:
    line, column = _utf16(span.source, span.start)
    end_line, end_column = _utf16(span.source, span.end)
    return {"startLine": line, "startColumn": column, "endLine": end_line, "endColumn": end_column}


def _utf16(source: Source, offset: int) -> tuple[int, int]:
    line, column = source.position(offset)
    before = source.line(line)[: column - 1]
    return line, len(before.encode("utf-16-le", "surrogatepass")) // 2 + 1


def _fix(fix: Fix) -> dict[str, Any]:
    replacements = by_key((edit.span.source, _replacement(edit)) for edit in fix.edits)
    return {
        "description": {"text": fix.title},
        "artifactChanges": [
            {"artifactLocation": _artifact(source), "replacements": replacements[source]}
            for source in replacements
        ],
    }


def _replacement(edit: Edit) -> dict[str, Any]:
    return {"deletedRegion": _region(edit.span), "insertedContent": {"text": edit.text}}
