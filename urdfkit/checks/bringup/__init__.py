"""What the programs of a launch file read, publish and expect of one another."""

from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_launch


def applies(context: Context) -> bool:
    """True for a launch file."""
    return is_launch(context.source.path)
