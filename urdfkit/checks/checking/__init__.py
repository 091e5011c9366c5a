"""The checking itself: comments that suppress findings."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if comments suppress findings."""
    return bool(subject.ignores)
