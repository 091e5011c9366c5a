"""Wheels and drives: the Gazebo plugins and controllers that turn joints."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if there are wheels, plugins of Gazebo or parameter files of controllers."""
    model = context.model
    names = [*(link.name for link in model.links), *(joint.name for joint in model.joints)]
    has_wheels = any("wheel" in name.lower() for name in names)
    return has_wheels or bool(context.parameters) or bool(model.gazebo and context.plugins)
