"""What reading a description met: errors of XML and of xacro."""

from __future__ import annotations

from collections.abc import Collection

from urdfkit.lint.context import Subject

#: Former codes and names, and the rules that report their findings now.
REDIRECTS = {
    "XML006": "XML001", "trailing-content": "XML001",
    "XML004": "XML007", "namespace-unbound": "XML007",
    "XAC015": "XAC017", "deprecated-syntax": "XAC017",
    "XAC019": "XAC001", "part-of-a-robot": "XAC001",
    "XAC012": "XAC009", "include-escapes-roots": "XAC009",
    "XAC016": "XAC017", "shadows-builtin": "XAC017",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True where reading met something."""
    return bool(subject.reading.problems)


def codes(subject: Subject) -> Collection[str]:
    """The rules that have something to report."""
    return {problem.code for problem in subject.reading.problems}
