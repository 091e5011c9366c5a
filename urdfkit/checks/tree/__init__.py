"""The kinematic tree."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a document with a robot in it."""
    return context.document.root.tag == "robot"
