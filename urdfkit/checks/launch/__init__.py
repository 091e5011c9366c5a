"""Launch files."""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.text.file_kinds import is_launch

#: Former codes and names of rules.
REDIRECTS = {
    "LAU008": "LAU005", "argument-not-given": "LAU005", "unknown-argument": "LAU005",
    "LAU007": "LAU005", "argument-not-taken": "LAU005",
    "LAU012": "LAU006", "configuration-undeclared": "LAU006",
    "LAU009": "LAU010", "LAU011": "LAU010", "unknown-tag-or-attribute": "LAU010",
    "attribute-missing": "LAU010", "words-run-together": "LAU010",
    "LAU018": "LAU016", "spawn-refused": "LAU016", "spawn-option-ignored": "LAU016",
    "substitution-not-made": "LAU019",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a launch file."""
    return is_launch(subject.source.path)
