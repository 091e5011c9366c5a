"""The report for programs."""

from __future__ import annotations

from urdfkit.core.strict_json import dumped
from urdfkit.output.report.document import Document


def render(document: Document) -> str:
    """The whole document; the same robot gives the same bytes."""
    return dumped(document)
