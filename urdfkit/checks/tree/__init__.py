"""The kinematic tree."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "TRE006": "TRE003", "joint-to-itself": "TRE003",
    "TRE009": "", "deep-chain": "",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it."""
    return subject.document.root.tag == "robot"
