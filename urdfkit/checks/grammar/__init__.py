"""The grammar of URDF: elements, attributes, values."""

from collections.abc import Collection

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True where the document deviates from the grammar."""
    return bool(context.deviations)


def codes(context: Context) -> Collection[str]:
    """The rules that report the deviations."""
    return context.deviations
