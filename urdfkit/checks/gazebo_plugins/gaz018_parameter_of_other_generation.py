"""A tag is one that the same plugin reads in another generation of Gazebo and ROS.

The plugins of ROS 1 read `<robotBaseFrame>`, those of ROS 2 `<robot_base_frame>`, and topics and
the namespace moved into a `<ros>` block. The old names have no effect and cause no message: the
plugin takes its defaults.

Sources:
    gazebo_ros_diff_drive.cpp of ROS 1: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/noetic-devel/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    gazebo_ros_diff_drive.cpp of ROS 2: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_plugins/src/gazebo_ros_diff_drive.cpp
    ros-simulation/gazebo_ros_pkgs#1377: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1377
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.ros.catalog.plugins import renames
from urdfkit.text.diagnostic import Fix, Severity
from urdfkit.text.document import Element
from urdfkit.text.editing.edits import rename_element

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.catalog.plugins import Plugin
    from urdfkit.ros.gazebo.plugins import PluginParameter

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <ros>
      <namespace>/robot</namespace>
    </ros>
    <odometry_frame>odom</odometry_frame>
    <robotBaseFrame>base</robotBaseFrame>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("robotBaseFrame", "robot_base_frame")
FIXED = GOOD

_NAMES = {"classic-ros1": "ROS 1", "classic-ros2": "ROS 2", "gz": "gz-sim", "classic": "no ROS"}


@rule(
    "GAZ018",
    "parameter-of-other-generation",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use, found in subject.unread:
        if found.other is None or use.plugin is None:
            continue
        element = found.item.at
        assert isinstance(element, Element)
        new = _renamed(found.item, use.plugin)
        edits = rename_element(element, new) if new and not use.values(new) else None
        yield Finding(
            element,
            f"{use.title} reads <{element.tag}> in {_NAMES[found.other.generation]}, and "
            f"nothing of that name in {_NAMES[use.plugin.generation]}",
            f"write <{new}>" if new else _advice(found.item, use.plugin),
            Fix.of(f"rename it to <{new}>", edits),
            alike=f"{use.filename} {'renamed' if edits else 'other'}",
        )


def _renamed(item: PluginParameter, plugin: Plugin) -> str | None:
    """The name that the same parameter has in this generation."""
    table = renames()
    if plugin.generation == "classic-ros1":
        table = {new: old for old, new in table.items()}
    name = table.get(item.path)
    found = plugin.parameters.get(name) if name else None
    return name if found and name and "/" not in name else None


def _advice(item: PluginParameter, plugin: Plugin) -> str:
    if plugin.generation != "classic-ros2":
        return "see which tags it reads there, or take the plugin of that generation"
    if item.path == "robotNamespace":
        return "write <ros><namespace>...</namespace></ros>"
    if item.path in ("updateRate", "updateRateHZ"):
        return "give the rate as <update_rate> of the sensor"
    if "topic" in item.path.lower():
        return "write <ros><remapping>FROM:=TO</remapping></ros>"
    return "remove it, or see what the plugin reads there"
