"""Whether an SRDF is for the robot."""

from urdfkit.lint.context import Context
from urdfkit.workspace.srdf_files import other_srdf_files, srdf_files


def applies(context: Context) -> bool:
    """True if there is an SRDF in the package of the robot or next to it."""
    path, resolver = context.source.path, context.resolver
    files = srdf_files(path, resolver) or other_srdf_files(path, context.model.name, resolver)
    return bool(files)
