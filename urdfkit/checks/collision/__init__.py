"""Self-collision: overlapping collision geometry, by coal."""

from __future__ import annotations

from urdfkit.core import libraries
from urdfkit.lint.context import WITHOUT_COAL, Subject, Unavailable

#: Codes and names of former rules, and the rules that report their findings now.
REDIRECTS = {
    "overlap-in-zero-pose": "COL001", "COL002": "COL001", "always-colliding-pair": "COL001",
    "COL006": "COL001", "adjacent-overlap": "COL001",
    "swallowed-body": "COL004",
    "COL003": "", "near-miss": "",
}  # fmt: skip


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
