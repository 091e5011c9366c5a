"""Controllers of ros2_control: their parameter files."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a launch file or a plugin names a parameter file."""
    return context.names_parameters
