"""Self-collision: overlapping collision geometry."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True if collision geometries of two links may overlap."""
    return (
        sum(bool(link.collisions) for link in subject.model.links) > 1
        and not subject.is_part
        and bool(subject.collisions.contacts.pairs)
    )
