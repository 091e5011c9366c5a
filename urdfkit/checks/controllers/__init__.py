"""Controllers of ros2_control: their parameter files."""

from __future__ import annotations

from urdfkit.lint.context import Context


def applies(subject: Context) -> bool:
    """True if a launch file or a plugin names a parameter file."""
    return bool(subject.parameters) or any(
        plugin.child("parameters")
        for block in subject.model.gazebo
        for plugin in block.all("plugin")
    )
