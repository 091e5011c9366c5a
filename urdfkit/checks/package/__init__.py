"""The ROS package of a robot or a launch file: dependencies, declarations, installed files."""

from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.package_references import have_references


def applies(context: Context) -> bool:
    """True for a launch file, and for a description that refers to packages or includes files."""
    if is_launch(context.source.path) or context.problems("XAC011"):
        return True
    document = context.reading.document
    sources = document.sources if document else (context.source,)
    if len(sources) > 1 or have_references(sources):
        return True
    return any(b"model://" in source.data for source in sources)
