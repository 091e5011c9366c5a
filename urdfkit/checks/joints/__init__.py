"""Joints: types, axes, limits, mimic."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if there are joints."""
    return bool(subject.model.joints)
