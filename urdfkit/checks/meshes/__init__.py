"""Mesh files that a robot refers to: whether programs find them."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a shape is a mesh file."""
    return any(shape.filename for shape in context.model.shapes)
