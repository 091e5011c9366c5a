"""Self-collision: overlapping collision geometry, by coal."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.core import libraries
from urdfkit.lint.context import WITHOUT_COAL, Unavailable

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if collision geometries of two links may overlap.

    Raises:
        Unavailable: coal is not installed.
    """
    if sum(bool(link.collisions) for link in subject.model.links) < 2:
        return False
    if libraries.find("coal") is None:
        raise Unavailable(WITHOUT_COAL)
    return subject.is_crowded
