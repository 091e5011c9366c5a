"""No program publishes the transform from odometry to the robot, which localization needs.

Source: REP 105; pal-robotics/tiago_simulation#37.
"""

from __future__ import annotations

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.unread_commands import DRIVE, is_known_reader
from urdfkit.checks.bringup.workspace_launches import all_launches, is_included, programs_of
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value, scalar

_FILTER, _SWITCH, _OF_DRIVE = "robot_localization", "publish_tf", "enable_odom_tf"
_FILTERS = ("ekf_node", "ukf_node")
_TRANSFORMS = "TFMessage"


def unpublished_odometry(context: Context) -> Findings:
    """A filter and a drive, both of which leave the transform to the other one."""
    filters = [node for node in context.launch.programs if node.executable in _FILTERS]
    if len(filters) != 1 or is_included(context):
        return
    launches = all_launches(context)
    programs = programs_of(launches)
    if not all(is_known_reader(node) and node.package != "tf2_ros" for node in programs):
        return
    others = [node for node in programs if node.executable in _FILTERS]
    given = [given_parameter(node, _SWITCH, context.resolver) or "" for node in others]
    if not all(text.lower() == "false" for text in given):
        return
    switches = [] if _is_bridged(programs, context) else _switches_of_drives(programs, context)
    if not switches or any(switch.boolean is not False for _, switch in switches):
        return
    drive, of_drive = switches[0]
    for node in nodes_in_files(filters[0].parameters.files, context.resolver):
        value = scalar(node.values, _SWITCH)
        if value and value.boolean is False:
            yield Finding(
                value.span,
                f"nothing publishes the transform from odometry to the robot: {_SWITCH} of "
                f"'{node.name}' and {_OF_DRIVE} of '{drive}' are false",
                f"write {_SWITCH}: true",
                related=(Related(of_drive.span, "the other one"),),
            )


def _is_bridged(programs: list[StartedProgram], context: Context) -> bool:
    """True if a bridge forwards transforms of Gazebo."""
    return any(
        topic.ros_type.endswith(_TRANSFORMS) and topic.direction != TO_GAZEBO
        for node in programs
        for topic in bridged_topics(node, context.resolver)
    )


def _switches_of_drives(
    programs: list[StartedProgram], context: Context
) -> list[tuple[str, Value]]:
    """The drives with their switches; empty if a controller is unknown or a drive has none."""
    defined = controllers_of_workspace(context)
    known = [defined.get(spawned.name) for spawned in spawned_controllers(programs)]
    drives = [drive for drive in known if drive and DRIVE.fullmatch(drive.type.rpartition("/")[2])]
    switches = [
        (drive.name, value) for drive in drives for value in drive.section.values(_OF_DRIVE)
    ]
    return switches if all(known) and len(switches) >= len(drives) else []
