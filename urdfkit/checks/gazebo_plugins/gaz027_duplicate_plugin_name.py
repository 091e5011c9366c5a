"""Two plugins of ROS 2 have the same name and namespace.

In ROS 2 each of these plugins is a node with the name of the plugin. A second node of that name is
refused, or both answer to the same topics and parameters, and one of the two seems dead.

Sources:
    ros-simulation/gazebo_ros_pkgs#1394: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1394
    ros-simulation/gazebo_ros_pkgs#1303: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1303
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from urdfkit.lint.rules import Finding, Need, rule
from urdfkit.text.diagnostic import Related, Severity

if TYPE_CHECKING:
    from urdfkit.lint.context import Subject
    from urdfkit.ros.gazebo.plugins import PluginUse

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin name="drive" filename="libgazebo_ros_planar_move.so">
    <robot_base_frame>base</robot_base_frame>
  </plugin>
  <plugin name="drive" filename="libgazebo_ros_p3d.so">
    <body_name>base</body_name>
  </plugin>
</gazebo>"""
GOOD = BAD.replace('"drive" filename="libgazebo_ros_p3d', '"pose" filename="libgazebo_ros_p3d')


@rule(
    "GAZ027",
    "duplicate-plugin-name",
    Severity.WARNING,
    needs=(Need.MODEL, Need.GAZEBO),
    help="give each plugin a name of its own, or another <ros><namespace>",
)
def check(subject: Subject) -> Iterator[Finding]:
    first: dict[tuple[str, str], PluginUse] = {}
    for use in subject.plugins:
        if use.plugin is None or not use.plugin.node or not use.name:
            continue
        namespaces = use.values("ros/namespace")
        namespace = namespaces[0].text.strip("/") if namespaces else ""
        other = first.setdefault((namespace, use.name), use)
        if other is not use:
            yield Finding(
                use.at.attributes["name"],
                f"{use.title} and {other.title} are two ROS nodes of one name",
                related=(Related(other.at.span, "the first of the name"),),
            )
