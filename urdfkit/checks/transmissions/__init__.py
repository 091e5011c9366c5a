"""``<transmission>`` elements."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if there are transmissions."""
    return bool(context.model.transmissions)
