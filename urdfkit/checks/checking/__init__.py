"""The checking itself: robots that are not checked, and comments that suppress findings."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for every description; the runner decides when each of its rules runs."""
    return True
