"""The grammar of URDF: elements, attributes, values."""

from __future__ import annotations

from collections.abc import Collection

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True where the document deviates from the grammar."""
    return bool(subject.deviations)


def codes(subject: Context) -> Collection[str]:
    """The rules that report the deviations."""
    return subject.deviations
