"""Mass and inertia."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a document that contains a link."""
    return bool(context.model.links)
