"""The report for programs."""

from __future__ import annotations

from urdfkit.jsontext import dumped
from urdfkit.page.document import Document


def render(document: Document) -> str:
    """The whole document; the same robot gives the same bytes."""
    return dumped(document)
