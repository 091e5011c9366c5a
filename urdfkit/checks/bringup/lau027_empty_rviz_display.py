"""RViz shows nothing of what its configuration names.

- A display has a class that RViz 2 does not have, such as `rviz/LaserScan` of ROS 1.
- The robot's meshes have paths, such as `$(find PACKAGE)/mesh.stl`, or Gazebo's `model://`: "Could
  not load resource".
- A display requires reliable messages, which a node publishes as best effort.
- The display of the map is volatile, and misses what map_server published before.
- The tool for goals or for the initial pose has the topic of ROS 1 or a misspelt one, which Nav2
  does not read.
- The frames of the robot have a `frame_prefix` that RobotModel does not have as `TF Prefix`, or
  robot_state_publisher publishes them on `/robot1/tf`, while RViz reads `/tf`.
- The configuration is not YAML.

Sources:
    RViz 2, display types: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/plugins_description.xml
    rviz_default_plugins, tf_link_updater.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_default_plugins/src/rviz_default_plugins/robot/tf_link_updater.cpp
    resource_retriever: https://github.com/ros/resource_retriever/blob/rolling/resource_retriever/src/retriever.cpp
"""

from urdfkit.checks.bringup.rviz_displays import (
    configurations,
    has_other_topics,
    incompatible_reliability,
    meshes_without_uri,
    read_by_rviz,
    unknown_classes,
    unread_goals,
    volatile_maps,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import topic_name
from urdfkit.text.located_yaml import load, scalar, syntax_error
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "launch/view.launch.xml"
BAD = """\
<launch>
  <node pkg="rviz2" exec="rviz2" args="-d $(dirname)/../view.rviz"/>
</launch>
"""
GOOD = BAD.replace("view.rviz", "sound.rviz")
_DISPLAYS = b"Visualization Manager:\n  Displays:\n    - Class: %s/LaserScan\n"
FILES = {
    "view.rviz": _DISPLAYS % b"rviz",
    "sound.rviz": _DISPLAYS % b"rviz_default_plugins",
    "package.xml": b"<package><name>arm</name></package>",
}

_PUBLISHER, _RVIZ = "robot_state_publisher", "rviz2"
_PREFIX, _PREFIX_OF_RVIZ = "frame_prefix", "TF Prefix"
_TF = "/tf"
#: A package whose programs copy messages to other topics.
_RELAY = "topic_tools"


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from _unreadable(context)
    yield from unknown_classes(context)
    yield from meshes_without_uri(context)
    yield from volatile_maps(context)
    yield from incompatible_reliability(context)
    yield from unread_goals(context)
    yield from _unprefixed_models(context)
    yield from _unread_transforms(context)


def _unreadable(context: Context) -> Findings:
    """Configurations that are not YAML: RViz starts with an empty one."""
    for file, source in configurations(context):
        is_mapping = isinstance(load(source), dict)
        if not is_mapping and (error := syntax_error(source)):
            at, reason = error
            note = Related(file.span, "the file is named here")
            message = f"RViz does not load its configuration: invalid YAML: {reason}"
            yield Finding(at, message, "fix the file, or save it anew in RViz", related=(note,))


def _unprefixed_models(context: Context) -> Findings:
    """Models without the prefix of the frames of the robot, which is the only one."""
    publishers = _publishers(context)
    if len(publishers) != 1 or context.launch.has_scopes:
        return
    (publisher,) = publishers
    prefix = given_parameter(publisher, _PREFIX, context.resolver) or ""
    prefix = prefix.lstrip("/")  # as tf2 does
    for file, display, kind in read_by_rviz(context) if prefix else ():
        given = scalar(display, _PREFIX_OF_RVIZ)
        at = given or scalar(display, "Class")
        shown = f"{given.text}/" if given and given.text else ""
        if kind.endswith("/RobotModel") and shown != prefix and at:
            of_rviz = prefix.removesuffix("/")
            is_whole = prefix != of_rviz
            yield Finding(
                at.span,
                f"RobotModel of RViz finds no frames: those of the robot start with '{prefix}'",
                f"write {_PREFIX_OF_RVIZ}: {of_rviz}"
                + ("" if is_whole else f", and {_PREFIX}: {prefix}/, as RViz adds a slash"),
                related=(
                    Related(file.span, "the file is named here"),
                    Related(publisher.span, f"{_PREFIX} is given here"),
                ),
            )


def _unread_transforms(context: Context) -> Findings:
    """RViz that reads the transforms from a topic on which no robot publishes them."""
    publishers = _publishers(context)
    programs = context.launch.programs
    is_known = not context.launch.has_scopes and not context.launch.unread
    if not publishers or not is_known or has_other_topics(context):
        return
    others = [node for node in programs if not comes_with_ros(node.package)]
    others += [node for node in programs if node.package == _RELAY or not node.is_sure]
    if others:
        return  # others may publish the transforms, too
    published = [topic_name(_TF, node) for node in publishers]
    viewers = [node for node in context.launch.started if node.package == _RVIZ]
    if all(published) and _TF not in published:
        for viewer in viewers:
            yield Finding(
                viewer.at,
                f"RViz reads the transforms from {_TF}, but {_PUBLISHER} publishes them on "
                f"{published[0]}",
                f"remap {_TF} to {published[0]}, and {_TF}_static to {published[0]}_static",
                related=(Related(publishers[0].span, "the publisher is started here"),),
            )


def _publishers(context: Context) -> list[StartedProgram]:
    return [node for node in context.launch.programs if node.package == _PUBLISHER]
