"""The XML text, independent of its content."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for every description."""
    return True
