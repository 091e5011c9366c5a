"""xacro: macros, properties, arguments, expressions."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "XAC018": "XAC003", "unexpanded-tag": "XAC003",
    "unused-property": "XAC004", "XAC005": "XAC004", "unused-macro": "XAC004", "XAC006": "XAC004",
    "unused-argument": "XAC004",
    "XAC022": "", "power-is-exclusive-or": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a xacro, and for a plain file with expressions or tags of xacro."""
    reading = subject.reading
    if reading.xacro is not None or any(one.code.startswith("XAC") for one in reading.problems):
        return True
    return any(sign in subject.source.data for sign in (b"${", b"$(", b"<xacro:"))
