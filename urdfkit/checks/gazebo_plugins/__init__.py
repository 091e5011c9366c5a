"""Plugins of Gazebo: libraries, parameters, the links and joints that they name."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if a ``<gazebo>`` element holds a plugin."""
    return bool(subject.plugins)
