"""The grammar of URDF: elements, attributes, values."""

from __future__ import annotations

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True where the document deviates from the grammar."""
    return bool(subject.deviations)
