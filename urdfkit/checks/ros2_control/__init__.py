"""``<ros2_control>`` and the interfaces of its joints."""

from urdfkit.lint.context import Context


def applies(context: Context) -> bool:
    """True if there are transmissions, ros2_control or plugins that run controllers."""
    model = context.model
    if model.transmissions or model.ros2_controls or context.parameters:
        return True
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return any("control" in (plugin.get("filename") or "") for plugin in plugins)
