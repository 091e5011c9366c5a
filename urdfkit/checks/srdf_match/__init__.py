"""Whether an SRDF is for the robot."""

from urdfkit.lint.context import Context
from urdfkit.workspace.srdf_files import has_srdf_files


def applies(context: Context) -> bool:
    """True if there is an SRDF in the package of the robot or next to it."""
    return has_srdf_files(context.source.path, context.model.name, context.resolver)
