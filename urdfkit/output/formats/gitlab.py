"""GitLab's code quality report: a JSON list that merge requests show.

Source of the format: GitLab's documentation of code quality reports.
"""

import json
from typing import Any

from urdfkit.lint.baseline import fingerprints
from urdfkit.lint.report import Report
from urdfkit.output.formats._paths import in_repository
from urdfkit.text.diagnostic import Diagnostic, Severity

_SEVERITIES = {Severity.ERROR: "major", Severity.WARNING: "minor", Severity.INFO: "info"}


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """All findings."""
    marks = fingerprints(report.diagnostics)
    issues = [_issue(d, mark) for d, mark in zip(report.diagnostics, marks, strict=True)]
    return json.dumps(issues, ensure_ascii=False, indent=1) + "\n"


def _issue(diagnostic: Diagnostic, mark: str) -> dict[str, Any]:
    span = diagnostic.span
    line, column = span.source.position(span.start)
    end_line, end_column = span.source.position(span.end)
    return {
        "description": diagnostic.message_with_variants,
        "check_name": f"{diagnostic.code} {diagnostic.name}",
        "fingerprint": mark,
        "severity": _SEVERITIES[diagnostic.severity],
        "location": {
            "path": in_repository(span.source.path),
            "positions": {
                "begin": {"line": line, "column": column},
                "end": {"line": end_line, "column": end_column},
            },
        },
    }
