"""A comparison as a JSON document; lengths in m, angles in rad, masses in kg."""

from typing import Any

from urdfkit.core.strict_json import dumped
from urdfkit.output.comparison import KINDS, Comparison
from urdfkit.robot.composite_body import CompositeBody
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import shown

#: Version of the document; an incompatible change increments it.
VERSION = 1


def render(comparison: Comparison, *, width: int = 80) -> str:
    document = {
        "version": VERSION,
        "before": comparison.before,
        "after": comparison.after,
        "kinds": [kind for kind in KINDS if kind in comparison.kinds],
        "tolerances": comparison.tolerances._asdict(),
        "differences": [
            {**change._asdict(), "sentence": str(change)} for change in comparison.differences
        ],
        "moved": [moved._asdict() for moved in comparison.moved],
        "total": {
            "before": _total(comparison.whole),
            "after": _total(comparison.whole_after),
            "center_moved": comparison.center_moved,
            "differs": comparison.total_differs,
        },
        "findings": {
            "came": [_finding(finding) for finding in comparison.new_findings],
            "went": [_finding(finding) for finding in comparison.fixed_findings],
        },
        "notes": list(comparison.notes),
    }
    return dumped(document)


def _total(whole: CompositeBody) -> dict[str, Any]:
    body = whole.properties
    return {
        "mass": whole.mass,
        "center": list(body.center) if body else None,
        "inertia": body.tensor._asdict() if body else None,
    }


def _finding(finding: Diagnostic) -> dict[str, Any]:
    return {
        "code": finding.code,
        "severity": finding.severity.value,
        "message": finding.message,
        "element": finding.element,
        "path": shown(finding.span.source.path),
        "line": finding.span.line,
        "column": finding.span.column,
    }
