"""Mass and inertia."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "INE002": "INE003", "not-positive-definite": "INE003", "triangle-inequality": "INE003",
    "INE017": "INE004", "tiny-mass": "INE004", "INE019": "INE004", "robot-without-mass": "INE004",
    "INE020": "INE004", "frame-drops-subtree": "INE004",
    "INE018": "INE005", "singular-inertia": "INE005",
    "inertia-too-large-for-geometry": "INE006", "INE007": "INE006",
    "inertia-too-small-for-geometry": "INE006", "INE015": "INE006", "transposed-tensor": "INE006",
    "mirrored-twins-differ": "INE012",
    "INE013": "XAC014", "same-tensor-on-different-links": "XAC014",
    "macro-gives-constant-inertia": "XAC014",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it."""
    return bool(subject.model.links)
