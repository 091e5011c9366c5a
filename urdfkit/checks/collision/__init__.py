"""Self-collision: overlapping collision geometry."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Codes and names of former rules, and the rules that report their findings now.
REDIRECTS = {
    "overlap-in-zero-pose": "COL001", "COL002": "COL001", "always-colliding-pair": "COL001",
    "COL006": "COL001", "adjacent-overlap": "COL001",
    "swallowed-body": "COL004",
    "COL003": "", "near-miss": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if collision geometries of two links may overlap."""
    return (
        sum(bool(link.collisions) for link in subject.model.links) > 1
        and not subject.is_part
        and bool(subject.collisions.contacts.pairs)
    )
