"""Mesh files: whether they are there, and what is in them."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject


def applies(subject: Subject) -> bool:
    """True if a shape is a mesh file."""
    return any(shape.filename for shape in subject.model.shapes)
