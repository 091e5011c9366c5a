"""``<transmission>`` elements."""

from __future__ import annotations

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if there are transmissions."""
    return bool(subject.model.transmissions)
