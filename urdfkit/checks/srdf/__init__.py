"""SRDF: MoveIt's groups, states and allowed-collision matrix."""

from urdfkit.lint.context import Context
from urdfkit.workspace.srdf_files import other_srdf_files, srdf_files


def applies(context: Context) -> bool:
    """True if an SRDF of this robot is near it."""
    path = context.source.path
    is_there = srdf_files(path, context.resolver) or other_srdf_files(
        path, context.model.name, context.resolver
    )
    return bool(is_there) and not context.other_variant
