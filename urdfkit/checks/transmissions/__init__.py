"""``<transmission>`` elements."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True if there are transmissions."""
    return bool(subject.model.transmissions)
