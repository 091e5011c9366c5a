"""Mesh files that a robot names: whether they exist."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a shape is a mesh file."""
    return any(shape.filename for shape in context.model.shapes)
