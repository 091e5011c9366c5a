"""The report for programs."""

from __future__ import annotations

import json

from urdfkit.page.document import Document


def render(document: Document) -> str:
    """The whole document; the same robot gives the same bytes."""
    return json.dumps(document, ensure_ascii=False, indent=2) + "\n"
