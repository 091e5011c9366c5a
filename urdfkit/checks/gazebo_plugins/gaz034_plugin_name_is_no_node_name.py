"""The name of a plugin cannot be that of a ROS 2 node.

In Gazebo Classic with ROS 2 the plugin is a node with the plugin's name. ROS 2 takes letters,
digits and underscores, and no digit first; with any other name the node's constructor throws, and
the plugin does not start.

Sources:
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    gazebo_ros, node.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/src/node.cpp
    open-rmf/rmf_simulation#109: https://github.com/open-rmf/rmf_simulation/issues/109
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

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="planar-move" filename="libgazebo_ros_planar_move.so">
    <robot_base_frame>base</robot_base_frame>
  </plugin>
</gazebo>"""
GOOD = BAD.replace("planar-move", "planar_move")
FIXED = GOOD


@rule(
    "GAZ034",
    "plugin-name-is-no-node-name",
    Severity.ERROR,
    needs=(Need.MODEL, Need.GAZEBO),
    fixable=True,
)
def check(subject: Subject) -> Iterator[Finding]:
    for use in subject.plugins:
        if use.plugin is None or not use.plugin.node or not use.name:
            continue
        if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", use.name):
            continue
        good = re.sub(r"[^A-Za-z0-9_]", "_", use.name)
        good = f"_{good}" if good[0].isdigit() else good
        attribute = use.at.attributes["name"]
        edits = replace_value(attribute, good)
        yield Finding(
            attribute,
            f"{use.title} becomes a ROS 2 node, whose name has letters, digits and underscores "
            "only, and no digit first",
            f"write '{good}'",
            Fix.of(f"rename it to '{good}'", edits),
        )
