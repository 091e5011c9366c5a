"""The text: encoding and well-formedness."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "XML006": "XML001", "trailing-content": "XML001",
    "XML004": "XML007", "namespace-unbound": "XML007",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for every description."""
    return True
