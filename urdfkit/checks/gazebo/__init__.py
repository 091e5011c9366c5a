"""The ``<gazebo>`` elements: references, tags, materials, frames."""

from __future__ import annotations

from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if there are ``<gazebo>`` elements."""
    return bool(subject.model.gazebo)
