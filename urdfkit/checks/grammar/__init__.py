"""The grammar of URDF: elements, attributes, values."""

from __future__ import annotations

from collections.abc import Collection

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True where the document deviates from the grammar."""
    return bool(subject.deviations)


def codes(subject: Subject) -> Collection[str]:
    """The rules that report the deviations."""
    return subject.deviations
