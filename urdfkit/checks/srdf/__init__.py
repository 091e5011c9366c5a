"""SRDF: MoveIt's groups, states and allowed-collision matrix."""

from urdfkit.lint.context import Context
from urdfkit.workspace.srdf_files import has_srdf_files


def applies(context: Context) -> bool:
    """True if there is an SRDF of this robot in its package or next to it."""
    has_files = has_srdf_files(context.source.path, context.model.name, context.resolver)
    return has_files and not context.other_variant
