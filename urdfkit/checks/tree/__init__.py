"""The kinematic tree."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True for a document with a robot in it."""
    return subject.document.root.tag == "robot"
