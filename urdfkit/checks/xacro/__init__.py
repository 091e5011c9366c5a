"""xacro: macros, properties, arguments, expressions."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True for a xacro, and for a plain file with expressions or tags of xacro."""
    reading = subject.reading
    if reading.xacro is not None or any(one.code.startswith("XAC") for one in reading.problems):
        return True
    return any(sign in subject.source.data for sign in (b"${", b"$(", b"<xacro:"))
