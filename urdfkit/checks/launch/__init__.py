"""Launch files."""

from __future__ import annotations

from typing import TYPE_CHECKING

from urdfkit.text.xml_reader import is_launch

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True for a launch file."""
    return is_launch(subject.source.path)
