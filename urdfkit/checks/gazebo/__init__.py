"""The ``<gazebo>`` elements: references, tags, materials, frames."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if the model has ``<gazebo>`` elements."""
    return bool(context.model.gazebo)
