"""Names of links, joints and materials, and references to them."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a document with a robot in it."""
    return bool(context.model.links or context.model.joints)
