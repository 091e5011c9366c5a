"""Two sensors of one link, or two ROS 2 plugins of one namespace, have the same name.

gz-sim rejects a model with two sensors of one name ("non-unique name"), Gazebo Classic makes only
one of them: an error. Links that fixed joints connect count as one, since Gazebo merges them.

In ROS 2 each plugin of Gazebo Classic is a node with the plugin's name. A second node of that name
is rejected, or both use the same topics and parameters, and one of the two seems dead: a warning.

Sources:
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    sdformat, Sensor.cc: https://github.com/gazebosim/sdformat/blob/main/src/Sensor.cc
    ros-simulation/gazebo_ros_pkgs#1394: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1394
    ros-simulation/gazebo_ros_pkgs#1303: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1303
"""

from __future__ import annotations

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.rejection import REJECTED_BY_GZ
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.text.diagnostic import Related, Severity

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


@rule(Severity.WARNING, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    yield from _plugins(subject)
    yield from _sensors(subject)


def _plugins(subject: Subject) -> Findings:
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
                f"{use.title} and {other.title} are ROS nodes of the same name",
                "give each plugin a name of its own, or another <ros><namespace>",
                related=(Related(other.at.span, "the first of that name"),),
            )


def _sensors(subject: Subject) -> Findings:
    first: dict[tuple[str, str], Sensor] = {}
    for sensor in sensors(subject.model):
        if not sensor.name or not sensor.reference:
            continue
        link = subject.gazebo.survivor.get(sensor.reference, sensor.reference)
        other = first.setdefault((link, sensor.name), sensor)
        if other is not sensor:
            merged = f" (merged into '{link}')" if link != sensor.reference else ""
            yield Finding(
                sensor.at.attributes["name"],
                f"two sensors '{sensor.name}' on '{sensor.reference}'{merged}: {REJECTED_BY_GZ}",
                "give each sensor a name of its own",
                related=(Related(other.at.span, "the first of that name"),),
                severity=Severity.ERROR,
            )
