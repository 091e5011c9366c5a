"""Names of links, joints and materials, and references to them."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True for a document that contains a link or a joint."""
    return bool(context.model.links or context.model.joints)
