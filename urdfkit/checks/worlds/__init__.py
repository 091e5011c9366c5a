"""The worlds of Gazebo that launch files start."""

from urdfkit.lint.context import Context
from urdfkit.text.file_kinds import is_launch


def applies(context: Context) -> bool:
    """True for a launch file that mentions Gazebo."""
    words = (b"gazebo", b"gz_", b"gz", b"ign")
    return is_launch(context.source.path) and any(word in context.source.data for word in words)
