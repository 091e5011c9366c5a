"""The kinematic tree."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a document whose root is ``<robot>``."""
    return context.document.root.tag == "robot"
