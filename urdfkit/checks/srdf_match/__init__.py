"""Whether the SRDF near a robot is that of this robot."""

from urdfkit.lint.context import Context
from urdfkit.workspace.srdf_files import other_srdf_files, srdf_files


def applies(context: Context) -> bool:
    """True if an SRDF is near the robot."""
    path = context.source.path
    return bool(
        srdf_files(path, context.resolver)
        or other_srdf_files(path, context.model.name, context.resolver)
    )
