"""Names of links, joints and materials, and references to them."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "NAM009": "NAM001", "material-redefined": "NAM001",
    "duplicate-link": "NAM001", "NAM002": "NAM001", "duplicate-joint": "NAM001", "NAM006": "NAM001",
    "duplicate-material": "NAM001",
    "illegal-character": "NAM004", "NAM005": "NAM004", "reserved-name": "NAM004",
    "NAM007": "NAM004", "tf-frame-slash": "NAM004", "NAM008": "NAM004", "leading-digit": "NAM004",
    "unknown-link": "REF001", "REF004": "REF001", "unknown-mimic-joint": "REF001",
    "NAM011": "", "names-differ-in-case": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it."""
    return bool(subject.model.links or subject.model.joints)
