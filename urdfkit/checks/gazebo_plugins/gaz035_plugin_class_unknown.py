"""The library of a plugin has no class of that name.

The `name` of a gz-sim plugin is not a free label, as it is in Gazebo Classic, but the class to be
made of the library. With another one Gazebo writes "library does not contain requested plugin" and
starts without it: the robot does not move, or sends no data.

Sources:
    gz-sim, SystemLoader.cc: https://github.com/gazebosim/gz-sim/blob/main/src/SystemLoader.cc
    Gazebo, system plugins: https://github.com/gazebosim/gz-sim/blob/main/tutorials/adding_system_plugins.md
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.editing.edits import replace_value

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.catalog.plugins import Plugin
    from urdfkit.ros.gazebo.plugins import PluginUse

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="pose_publisher" filename="gz-sim-pose-publisher-system"/>
</gazebo>"""
GOOD = BAD.replace("pose_publisher", "gz::sim::systems::PosePublisher")
FIXED = GOOD


@rule(
    "GAZ035",
    "plugin-class-unknown",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        classes = [_class_of(plugin, use) for plugin in use.known if plugin.class_name]
        name = use.at.attributes.get("name")
        if not classes or not use.name or name is None:
            continue  # GAZ010 tells of no name
        if _todays(use.name) not in map(_todays, classes):
            edits = replace_value(name, classes[0])
            yield Finding(
                name,
                f"{use.title}: the library has no class of that name, but {' and '.join(classes)}",
                f'write name="{classes[0]}"',
                Fix.of(f"name the class {classes[0]}", edits),
            )


def _class_of(plugin: Plugin, use: PluginUse) -> str:
    """As the file is called: that of Fortress has a class of Fortress."""
    return plugin.fortress_class if "ignition" in use.filename else plugin.class_name


def _todays(name: str) -> str:
    """A class as it is called today: Fortress had other words, and versions may be spelt out."""
    return re.sub(r"::v\d+\b", "", name.replace("ignition::gazebo", "gz::sim"))
