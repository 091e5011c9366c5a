"""Gazebo plugins: libraries, parameters, the links and joints that they refer to."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a ``<gazebo>`` element contains a plugin."""
    return bool(context.plugins)
