"""The grammar of URDF: elements, attributes, values."""

from __future__ import annotations

from collections.abc import Collection

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "URD012": "URD001", "misplaced-element": "URD001", "URD013": "URD001",
    "misspelt-required-element": "URD001",
    "URD010": "URD003", "robot-without-name": "URD003", "NAM010": "URD003", "empty-name": "URD003",
    "URD009": "URD004", "empty-geometry": "URD004",
    "URD006": "URD005", "wrong-vector-length": "URD005",
    "unknown-version": "URD011", "URD014": "URD011", "newer-version": "URD011", "URD016": "URD011",
    "version-too-low": "URD011",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True where the document deviates from the grammar."""
    return bool(subject.deviations)


def codes(subject: Subject) -> Collection[str]:
    """The rules that report the deviations."""
    return subject.deviations
