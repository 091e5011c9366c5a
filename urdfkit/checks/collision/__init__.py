"""Self-collision: overlapping collision geometry."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if collision geometries of two links may overlap."""
    return (
        sum(bool(link.collisions) for link in context.model.links) > 1
        and not context.is_part
        and bool(context.collisions.contacts.pairs)
    )
