"""reviewdog's JSON by lines: every finding a document of its own, as ``rdjson`` has it."""

from __future__ import annotations

import json

from urdfkit.lint.report import Report
from urdfkit.output.formats.rdjson import SOURCE, as_json


def render(report: Report, *, color: bool = False, width: int = 80) -> str:
    """A line for every finding."""
    findings = ({**as_json(diagnostic), "source": SOURCE} for diagnostic in report.diagnostics)
    return "".join(json.dumps(finding, ensure_ascii=False) + "\n" for finding in findings)
