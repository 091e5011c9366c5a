"""The text, whatever it describes."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for every description."""
    return True
