"""The text, whatever it describes."""

from __future__ import annotations

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True for every description."""
    return True
