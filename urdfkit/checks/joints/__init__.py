"""Joints: types, axes, limits, mimic."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True for a document with a robot in it: links have poses, too."""
    return bool(subject.model.joints or subject.model.links)
