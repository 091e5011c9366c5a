"""Sensors of Gazebo: types, rates, ranges, frames."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if a ``<gazebo>`` element contains a sensor."""
    return any(part.tag == "sensor" for block in context.model.gazebo for part in block.walk())
