"""Controllers of ros2_control: their parameter files."""

from __future__ import annotations

from urdfkit.lint.context import Subject

#: Former codes and names of rules.
REDIRECTS = {
    "RCT012": "RCT026", "parameters-file-missing": "RCT026", "parameters-not-read": "RCT026",
    "RCT027": "RCT034", "RCT035": "RCT034", "RCT036": "RCT034", "parameter-refused": "RCT034",
    "controller-parameter-misspelt": "RCT034", "required-parameter-missing": "RCT034",
    "controller-class-unknown": "RCT034",
}  # fmt: skip


def applies(subject: Subject) -> bool:
    """True if a launch file or a plugin names a parameter file."""
    return bool(subject.parameters) or any(
        plugin.child("parameters")
        for block in subject.model.gazebo
        for plugin in block.all("plugin")
    )
