"""xacro: macros, properties, arguments, expressions."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True for a xacro, and for a plain file with expressions or tags of xacro."""
    return subject.reading.xacro is not None or any(
        sign in subject.source.data for sign in (b"${", b"$(", b"<xacro:")
    )
