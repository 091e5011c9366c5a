"""The package of a robot: what it mentions and what its build installs."""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.workspace.package_references import are_in


def applies(subject: Subject) -> bool:
    """True if the description mentions packages."""
    return are_in(subject.document.sources)
