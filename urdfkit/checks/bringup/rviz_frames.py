"""Robots that RViz does not show: their frames have a prefix, or are on another topic.

Sources: ``tf_link_updater.cpp`` of rviz_default_plugins, Humble to Rolling: a prefix is followed by
a slash.
"""

from urdfkit.checks.bringup.rviz_displays import has_other_topics, read_by_rviz
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import topic_name
from urdfkit.text.located_yaml import scalar
from urdfkit.workspace.ros_packages import comes_with_ros

_PUBLISHER, _RVIZ = "robot_state_publisher", "rviz2"
_PREFIX, _PREFIX_OF_RVIZ = "frame_prefix", "TF Prefix"
_TF = "/tf"
#: A package whose programs copy messages to other topics.
_RELAY = "topic_tools"


def unprefixed_models(context: Context) -> Findings:
    """Models without the prefix of the frames of the robot, which is the only one."""
    publishers = _publishers(context)
    if len(publishers) != 1 or context.launch.has_scopes:
        return
    (publisher,) = publishers
    prefix = given_parameter(publisher, _PREFIX, context.resolver)
    for file, display, kind in read_by_rviz(context) if prefix else ():
        given = scalar(display, _PREFIX_OF_RVIZ)
        at = given or scalar(display, "Class")
        shown = f"{given.text}/" if given and given.text else ""
        if kind.endswith("/RobotModel") and shown != prefix and at:
            of_rviz = (prefix or "").removesuffix("/")
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


def unread_transforms(context: Context) -> Findings:
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
