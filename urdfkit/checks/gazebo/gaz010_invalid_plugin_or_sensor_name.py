"""A plugin has no valid `name` or no `filename`, or a sensor has no name.

SDF requires all of them: up to SDF 1.9 Gazebo rejects the whole model without them. The file name
of a plugin is that of its library; the name is free in Gazebo Classic and the class in gz-sim.

In Gazebo Classic with ROS 2 the plugin is a node with the plugin's name. ROS 2 allows letters,
digits and underscores, and no digit first; with any other name the node's constructor throws, and
the plugin does not start.

Sources:
    sdformat, Plugin.cc: https://github.com/gazebosim/sdformat/blob/main/src/Plugin.cc
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    moveit/moveit#3572: https://github.com/moveit/moveit/issues/3572
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    gazebo_ros, node.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/src/node.cpp
    open-rmf/rmf_simulation#109: https://github.com/open-rmf/rmf_simulation/issues/109
"""

from __future__ import annotations

import re

from urdfkit.lint.context import Subject
from urdfkit.lint.rules import Finding, Findings, Need, rule
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.rejection import REJECTED
from urdfkit.ros.gazebo.sensors import sensors
from urdfkit.text.diagnostic import Edit, Fix, Severity
from urdfkit.text.editing.edits import replace_value
from urdfkit.text.source import Span

BAD = """\
<link name="base">
  <inertial>
    <mass value="1"/>
    <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>
  </inertial>
</link>
<gazebo>
  <plugin filename="libgazebo_ros_planar_move.so"/>
</gazebo>"""
GOOD = BAD.replace("<plugin", '<plugin name="drive"')
FIXED = BAD.replace("<plugin", '<plugin name="gazebo_ros_planar_move"')


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(subject: Subject) -> Findings:
    for use in subject.plugins:
        for attribute, what in (("name", "its name"), ("filename", "the file name of its library")):
            if not (use.at.get(attribute) or "").strip():
                other = use.filename if attribute == "name" else use.name and f"'{use.name}'"
                who = f"plugin {other}" if other else "a plugin"
                message = f"{who} has no {attribute}: {REJECTED}"
                fix = _named(subject, use) if attribute == "name" else None
                yield Finding(use.at, message, f'add {attribute}="...", {what}', fix)
        if use.plugin and use.plugin.node and use.name:
            yield from _invalid_node_name(use)
    for sensor in sensors(subject.model):
        if not sensor.name.strip():
            kind = f" of type '{sensor.type}'" if sensor.type else ""
            message = f"a sensor{kind} of '{sensor.reference}' has no name: {REJECTED}"
            yield Finding(sensor.at, message, 'add name="...", unique in the link')


def _named(subject: Subject, use: PluginUse) -> Fix | None:
    """The name of the library for a plugin that has no attribute of that name, if it is free."""
    name = use.filename.removeprefix("lib").removesuffix(".so")
    taken = {other.name for other in subject.plugins}
    if "name" in use.at.attributes or not re.fullmatch(r"[a-z]\w*", name) or name in taken:
        return None
    source, _, end = use.at.tag_at.name_span
    return Fix(f'add name="{name}"', (Edit(Span(source, end, end), f' name="{name}"'),))


def _invalid_node_name(use: PluginUse) -> Findings:
    if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", use.name):
        return
    good = re.sub(r"[^A-Za-z0-9_]", "_", use.name)
    good = f"_{good}" if good[0].isdigit() else good
    attribute = use.at.attributes["name"]
    yield Finding(
        attribute,
        f"{use.title}: the name is not a valid ROS 2 node name (letters, digits and underscores, "
        "no digit first)",
        f"write '{good}'",
        Fix.of(f"rename it to '{good}'", replace_value(attribute, good)),
    )
