"""The name of a plugin or sensor is missing, invalid, or not unique.

SDF requires a name, and the `filename` of the library of a plugin: up to SDF 1.9 Gazebo rejects the
whole model without them. The name of a plugin is free in Gazebo Classic and the class in gz-sim.

Sensors of one link have different names: gz-sim rejects a model with two of one name ("non-unique
name"), Gazebo Classic creates only one of them (a warning, if a file is included twice). Links that
fixed joints connect count as one, since Gazebo merges them.

In gz-sim two sensors with the same `<topic>` (warning) publish on one topic, for example if a macro
with a fixed topic is called twice: subscribers receive both in turn. So do two cameras of Gazebo
Classic with ROS 2 that have one `<camera_name>` in one namespace, without remappings.

In Gazebo Classic with ROS 2 a plugin is a node with the plugin's name. ROS 2 allows letters, digits
and underscores, and no digit first; with any other name the plugin does not start. Of two plugins
with one name in one namespace (warning) the second is rejected, or both use the same topics and
parameters.

Sources:
    sdformat, Plugin.cc: https://github.com/gazebosim/sdformat/blob/main/src/Plugin.cc
    SDF, sensor: http://sdformat.org/spec?ver=1.9&elem=sensor
    moveit/moveit#3572: https://github.com/moveit/moveit/issues/3572
    ROS 2, names: https://design.ros2.org/articles/topic_and_service_names.html
    gazebo_ros, node.cpp: https://github.com/ros-simulation/gazebo_ros_pkgs/blob/ros2/gazebo_ros/src/node.cpp
    sdformat, Sensor.cc: https://github.com/gazebosim/sdformat/blob/main/src/Sensor.cc
    ros-simulation/gazebo_ros_pkgs#1394: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1394
    ros-simulation/gazebo_ros_pkgs#1303: https://github.com/ros-simulation/gazebo_ros_pkgs/issues/1303
    open-rmf/rmf_simulation#109: https://github.com/open-rmf/rmf_simulation/issues/109
"""

import re

from urdfkit.core.grouping import repeated
from urdfkit.core.suggest import is_typo
from urdfkit.lint.rules import Context, Finding, Findings, Fix, Need, Related, Severity, rule
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo import REJECTED, REJECTED_BY_GZ
from urdfkit.ros.gazebo.plugins import PluginUse
from urdfkit.ros.gazebo.samples import gazebo_xml, solid_xml
from urdfkit.ros.gazebo.sensors import Sensor, sensors
from urdfkit.ros.targets import CLASSIC, GZ
from urdfkit.text.editing.edits import first_attribute, fix_value, rename_attribute
from urdfkit.text.grammar import is_expression

BAD = robot_xml(solid_xml("base"), gazebo_xml('<plugin filename="libgazebo_ros_planar_move.so"/>'))
GOOD = BAD.replace("<plugin", '<plugin name="drive"')
FIXED = BAD.replace("<plugin", '<plugin name="gazebo_ros_planar_move"')

_ONE_IN_CLASSIC = "Gazebo Classic creates only one of them"


@rule(Severity.ERROR, needs=(Need.MODEL, Need.GAZEBO))
def check(context: Context) -> Findings:
    for use in context.plugins:
        if use.place != "link":  # Gazebo does not read it there (GAZ014)
            yield from _missing(context, use)
        if use.plugin and use.plugin.node and use.name and not is_expression(use.name):
            yield from _invalid_node_name(use)
    for sensor in sensors(context.model):
        if not sensor.name.strip():
            kind = f" of type '{sensor.type}'" if sensor.type else ""
            message = f"sensor{kind} on '{sensor.reference}' has no name: {REJECTED}"
            yield Finding(sensor.at, message, 'add name="...", unique in the link')
    yield from _duplicate_plugins(context)
    yield from _shared_camera_names(context)
    yield from _duplicate_sensors(context)
    if context.targets.any_of(GZ):
        yield from _shared_topics(context)


def _missing(context: Context, use: PluginUse) -> Findings:
    for attribute in ("name", "filename"):
        if (use.at.get(attribute) or "").strip():
            continue
        other = use.filename if attribute == "name" else use.name and f"'{use.name}'"
        who = f"plugin {other}" if other else "<plugin>"
        help = f'add {attribute}="..."' + (" with the library" if attribute == "filename" else "")
        fix = _renamed(use, attribute)
        fix = fix or (_named(context, use) if attribute == "name" else None)
        yield Finding(use.at, f"{who} has no {attribute}: {REJECTED}", help, fix)


def _duplicate_plugins(context: Context) -> Findings:
    """The ROS nodes of one name in one namespace."""
    nodes = (use for use in context.plugins if use.plugin and use.plugin.node and use.name)
    keyed = (((use.value("ros/namespace").strip("/"), use.name), use) for use in nodes)
    for use, other in repeated(keyed):
        yield Finding(
            use.at.attributes["name"],
            f"{use.title} and {other.title} are ROS nodes of the same name",
            "give each plugin a unique name, or another <ros><namespace>",
            related=(Related(other.at.span, "first defined here"),),
            severity=Severity.WARNING,
        )


def _shared_camera_names(context: Context) -> Findings:
    """Cameras of Gazebo Classic with ROS 2 whose images have one topic."""
    cameras = (use for use in context.plugins if use.values("camera_name"))
    keyed = (
        ((use.value("ros/namespace").strip("/"), use.value("camera_name")), use)
        for use in cameras
        if not use.value("ros/remapping")
    )
    for use, other in repeated(keyed):
        if use.name == other.name:
            continue  # reported already
        topic = f"{use.value('camera_name')}/image_raw"
        yield Finding(
            use.at.child_or_self("camera_name"),
            f"{use.title} and {other.title} both publish on '{topic}'",
            "give each camera another <camera_name>",
            related=(Related(other.at.span, "the other camera"),),
            severity=Severity.WARNING,
        )


def _duplicate_sensors(context: Context) -> Findings:
    first: dict[tuple[str, str], Sensor] = {}
    for sensor in sensors(context.model):
        if not sensor.name or not sensor.reference:
            continue
        link = context.gazebo.survivor.get(sensor.reference, sensor.reference)
        other = first.setdefault((link, sensor.name), sensor)
        if other is not sensor:
            merged = f" (merged into '{link}')" if link != sensor.reference else ""
            is_same = sensor.at.span == other.at.span and not _in_macro(sensor)
            in_classic = context.targets.any_of(CLASSIC) and not context.targets.any_of(GZ)
            yield Finding(
                sensor.at.attributes["name"],
                f"duplicate {sensor.who} on '{sensor.reference}'{merged}: "
                + (_ONE_IN_CLASSIC if in_classic else REJECTED_BY_GZ),
                "include its file once" if is_same else "give each sensor a unique name",
                related=(Related(other.at.span, "first defined here"),),
                severity=Severity.WARNING if is_same and in_classic else None,
            )


def _shared_topics(context: Context) -> Findings:
    """The sensors of gz-sim that publish on the topic of another one."""
    first: dict[tuple[str, bool], Sensor] = {}
    for sensor in sensors(context.model):
        topic = sensor.find("topic")
        name = topic.text.strip().strip("/") if topic else ""
        if topic is None or not name or is_expression(name):
            continue
        # This type alone publishes below its topic and not on it.
        other = first.setdefault((name, sensor.type == "rgbd_camera"), sensor)
        if other is not sensor and sensor.name != other.name:
            yield Finding(
                topic,
                f"{sensor.who} on '{sensor.reference}' and {other.who} on '{other.reference}' "
                f"both publish on '{name}'",
                "give each sensor a topic of its own",
                related=(Related(other.at.span, "the other sensor"),),
                severity=Severity.WARNING,
            )


def _in_macro(sensor: Sensor) -> bool:
    return any(step.kind == "macro" for step in sensor.at.via)


def _renamed(use: PluginUse, missing: str) -> Fix | None:
    """Rename an attribute such as ``nmae``."""
    for attribute in use.at.attributes.values():
        if attribute.name != missing and is_typo(attribute.name, missing):
            return Fix.of(
                f"rename {attribute.name} to {missing}", rename_attribute(attribute, missing)
            )
    return None


def _named(context: Context, use: PluginUse) -> Fix | None:
    """Name a plugin without a name after its library, if no other plugin has that name."""
    name = use.filename.removeprefix("lib").removesuffix(".so")
    taken = {other.name for other in context.plugins}
    if "name" in use.at.attributes or not re.fullmatch(r"[a-z]\w*", name) or name in taken:
        return None
    return Fix(f'add name="{name}"', first_attribute(use.at, "name", name))


def _invalid_node_name(use: PluginUse) -> Findings:
    if re.fullmatch(r"[A-Za-z_][A-Za-z0-9_]*", use.name):
        return
    good = re.sub(r"[^A-Za-z0-9_]", "_", use.name)
    good = f"_{good}" if good[0].isdigit() else good
    attribute = use.at.attributes["name"]
    message = f"{use.title}: '{use.name}' is not a valid ROS 2 node name"
    help = f"write '{good}': letters, digits and underscores, no digit first"
    yield Finding(attribute, message, help, fix_value(attribute, good))
