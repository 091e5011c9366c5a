"""A topic is read that nothing publishes, or published that nothing reads.

- A filter, a costmap, a program of the workspace or all displays of RViz read odometry, an IMU,
  images or a scan from a topic that nothing publishes, while such messages are published on another
  topic. Reported only if all programs of the workspace, and the publishers of the robot in RViz,
  are known. One of several displays of scans is, too, if a scan is published that RViz does not
  show.
- Such a topic is published in Gazebo by a sensor of the robot, but no bridge forwards it.
- The mask of a filter, or its `filter_info_topic`, is on another topic than its server says.
- robot_localization and the controller of the wheels both leave the transform from odometry to the
  robot to the other one, as a filter does whose `world_frame` is the map. Or a filter leaves it to
  a drive of gz-sim, whose transforms no bridge forwards. Or Nav2 needs it, and the controller of
  the wheels alone could publish it. Or AMCL does not publish that of the map.
- Nothing reads the velocity commands of twist_mux, Nav2 or a teleoperation node, while a drive
  reads them on another topic. Reported only if all programs of the workspace are known.
- A teleoperation node, or Nav2, publishes `Twist` on the topic of a drive that reads
  `TwistStamped`, as those of ros2_control do: no message arrives, without an error.
- A program of the workspace names the action of a controller, or one of several joints, with a
  typo: it waits for ever, or the controller rejects its goals.
- The collision monitor of Nav2 reads commands on another topic than that of the velocity smoother.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    REP 105, coordinate frames: https://www.ros.org/reps/rep-0105.html
    pal-robotics/tiago_simulation#37: https://github.com/pal-robotics/tiago_simulation/issues/37
    turtlebot/turtlebot4#571: https://github.com/turtlebot/turtlebot4/issues/571
    robot_localization, ros_filter.cpp: https://github.com/cra-ros-pkg/robot_localization/blob/ros2/src/ros_filter.cpp
    twist_mux, twist_mux.cpp: https://github.com/ros-teleop/twist_mux/blob/rolling/src/twist_mux.cpp
"""

from __future__ import annotations

import re
from itertools import chain

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.gz_bridges import bridges_of_gz, may_bridge_transforms
from urdfkit.checks.bringup.known_programs import are_topics_known
from urdfkit.checks.bringup.names_in_programs import misspelt_names
from urdfkit.checks.bringup.navigation_commands import mistyped_navigation, unpublished_commands
from urdfkit.checks.bringup.odometry import of_global_filters
from urdfkit.checks.bringup.unpublished_topics import unpublished_inputs, unpublished_scans
from urdfkit.checks.bringup.unread_commands import (
    DRIVE,
    is_known_reader,
    mistyped_commands,
    unread_commands,
)
from urdfkit.checks.bringup.workspace_launches import (
    all_launches,
    is_included,
    programs_of,
    robots_of_workspace,
)
from urdfkit.lint.rules import Context, Finding, Findings, Need, Related, Severity, rule
from urdfkit.ros.gazebo.topics import are_all_known
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.launch.transforms import static_transform
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value, scalar
from urdfkit.workspace.program_strings import may_publish

NAME = "launch/drive.launch.xml"
BAD = """\
<launch>
  <node pkg="teleop_twist_keyboard" exec="teleop_twist_keyboard"/>
  <node pkg="ros_gz_bridge" exec="parameter_bridge"
        args="/drive/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist"/>
</launch>
"""
GOOD = BAD.replace("/drive/cmd_vel", "/cmd_vel")

_FILTER, _SWITCH, _OF_DRIVE = "robot_localization", "publish_tf", "enable_odom_tf"
_WORLD = "world_frame"
_FILTERS = ("ekf_node", "ukf_node")
_AMCL, _BROADCAST, _MAPPING = "nav2_amcl", "tf_broadcast", ("slam_toolbox",)
_NAVIGATION = (_AMCL, "nav2_controller", "slam_toolbox")
#: Packages whose programs publish no transforms, and those whose programs may move the robot.
_STILL, _MOVING = re.compile(r"topic_tools|twist_stamper"), ("tf2_ros", _FILTER)


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    yield from misspelt_names(context)
    if are_topics_known(context):
        yield from unpublished_inputs(context)
        yield from unpublished_scans(context)
        yield from unread_commands(context)
        yield from _unpublished_odometry(context)
        yield from _navigation_without_odometry(context)
        yield from _unpublished_map(context)
        yield from mistyped_commands(context, context.launch.programs)
        yield from mistyped_navigation(context, context.launch.programs)
        yield from unpublished_commands(context)


def _unpublished_odometry(context: Context) -> Findings:
    """A filter and a drive, both of which leave the transform to the other one."""
    filters = [node for node in context.launch.programs if node.executable in _FILTERS]
    if len(filters) != 1 or is_included(context):
        return
    launches = all_launches(context)
    programs = programs_of(launches)
    if any(_may_publish_transforms(node, context) for node in programs):
        return
    others = [node for node in programs if node.executable in _FILTERS]
    silent = [given_parameter(node, _SWITCH, context.resolver) or "" for node in others]
    maps = [transform.parent for transform in of_global_filters(others, context)]
    are_global = len(maps) == len(others)
    if not are_global and not all(text.lower() == "false" for text in silent):
        return
    is_bridged = may_bridge_transforms(programs, context.resolver)
    switches = [] if is_bridged else _switches_of_drives(programs, context)
    if is_bridged or any(switch.boolean is not False for _, switch in switches):
        return
    if not switches and not _only_gazebo_drives(programs, context):
        return
    drive, of_drive = switches[0] if switches else ("", None)
    for node in nodes_in_files(filters[0].parameters.files, context.resolver):
        value = scalar(node.values, _WORLD if are_global else _SWITCH)
        own = f"{_SWITCH} of '{node.name}' is false"
        if are_global:
            own = f"{_WORLD} of '{node.name}' is the map"
        if value and (value.text in maps if are_global else value.boolean is False):
            yield Finding(
                value.span,
                f"nothing publishes the transform from odometry to the robot: {own}"
                + (f", and {_OF_DRIVE} of '{drive}' is false" if of_drive else ""),
                f"write {_WORLD}: odom" if are_global else f"write {_SWITCH}: true",
                related=(Related(of_drive.span, "the other one"),) if of_drive else (),
            )


def _only_gazebo_drives(programs: list[StartedProgram], context: Context) -> bool:
    """True if plugins of gz-sim drive all robots, and a program needs their transforms."""
    is_needed = any(node.package in _NAVIGATION for node in programs)
    if not is_needed or bridges_of_gz(tuple(programs)) is None:
        return False
    defined = controllers_of_workspace(context)
    known = [defined.get(spawned.name) for spawned in spawned_controllers(programs)]
    if not all(one and not DRIVE.fullmatch(one.type.rpartition("/")[2]) for one in known):
        return False
    robots = list(robots_of_workspace(context))
    return bool(robots) and all(are_all_known(robot.model) for robot in robots)


def _may_publish_transforms(program: StartedProgram, context: Context) -> bool:
    """True if a program, next to filters and drives, may publish transforms."""
    if _is_of_other_frames(program):
        return False
    if program.package == "tf2_ros" or is_known_reader(program):
        return program.package == "tf2_ros"
    return may_publish(program.package, "Transform", context.source.path, context.resolver)


def _navigation_without_odometry(context: Context) -> Findings:
    """A drive that does not publish the transform that Nav2 needs, and which nothing publishes."""
    running = (node for node in context.launch.programs if node.is_sure)
    reader = next((node for node in running if node.package in _NAVIGATION), None)
    if reader is None or is_included(context):
        return
    programs = programs_of(all_launches(context))
    is_bridged = may_bridge_transforms(programs, context.resolver)
    if is_bridged or any(_may_move(node, context) for node in programs):
        return
    switches = _switches_of_drives(list(context.launch.programs), context)
    for drive, switch in switches if all(on.boolean is False for _, on in switches) else ():
        yield Finding(
            switch.span,
            "nothing publishes the transform from odometry to the robot: "
            f"{_OF_DRIVE} of '{drive}' is false",
            f"write {_OF_DRIVE}: true",
            related=(Related(reader.span, f"'{reader.title}' needs it"),),
        )


def _unpublished_map(context: Context) -> Findings:
    """AMCL that does not publish the transform of the map, where no other node does."""
    filters = [node for node in context.launch.started if node.package == _AMCL]
    sections = [nodes_in_files(node.parameters.files, context.resolver) for node in filters]
    switches = [
        scalar(section.values, _BROADCAST)
        for section in chain.from_iterable(sections)
        if section.name == "amcl"
    ]
    silent = [value for value in switches if value and value.boolean is False]
    programs = programs_of(all_launches(context)) if silent else []
    statics = [transform for node in programs if (transform := static_transform(node))]
    is_mapped = (
        any(node.package in _MAPPING for node in context.launch.programs)
        or any(_may_publish_transforms(node, context) for node in programs)
        or any("odom" in (transform.child.text or "odom") for transform in statics)
        or any(of_global_filters(programs, context))
        or may_bridge_transforms(programs, context.resolver)
    )
    for value in silent if not is_mapped else ():
        yield Finding(
            value.span,
            f"nothing publishes the transform from the map to odometry: {_BROADCAST} of 'amcl' is "
            "false",
            f"write {_BROADCAST}: true",
        )


def _may_move(program: StartedProgram, context: Context) -> bool:
    """True if a program may publish the transform of the robot."""
    is_still = _STILL.fullmatch(program.package) or is_known_reader(program)
    if (is_still and program.package not in _MOVING) or _is_of_other_frames(program):
        return False
    return may_publish(program.package, "TransformStamped", context.source.path, context.resolver)


def _is_of_other_frames(program: StartedProgram) -> bool:
    """True for a static transform that is not the one from odometry, or a map, to the robot."""
    transform = static_transform(program)
    if transform is None:
        return False
    parent, child = transform.parent.text or "odom", transform.child.text or "base"
    return "odom" not in parent and "base" not in child


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
