"""The ROS package around a robot or a launch file: what it needs, declares and installs."""

from __future__ import annotations

from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.package_references import are_in


def applies(subject: Context) -> bool:
    """True for a launch file, and for a description that refers to packages."""
    if is_launch(subject.source.path) or subject.problems("XAC011"):
        return True
    document = subject.reading.document
    sources = document.sources if document else (subject.source,)
    return are_in(sources) or any(b"model://" in source.data for source in sources)
