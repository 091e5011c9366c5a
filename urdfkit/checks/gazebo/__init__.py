"""The ``<gazebo>`` elements: references, tags, materials, frames."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True if there are ``<gazebo>`` elements."""
    return bool(subject.model.gazebo)
