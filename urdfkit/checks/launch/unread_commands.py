"""Velocity commands that a node publishes and that nothing reads.

Reported only where all that runs in the workspace is known, and some of it reads velocity commands
under another name.

Sources: ``twist_mux.cpp`` of ros-teleop/twist_mux, ``teleop_twist_joy.cpp`` of
ros2/teleop_twist_joy, ``diff_drive_controller.cpp`` of ros2_controllers (all of humble to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from urdfkit.checks.launch.defined_controllers import defined_controllers
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.gazebo.topics import are_all_known
from urdfkit.ros.launch.argument_checks import is_included
from urdfkit.ros.launch.bridges import FROM_GAZEBO, bridged_topics
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.spawned_controllers import MANAGER, controllers, topic_name
from urdfkit.text.source import Span
from urdfkit.workspace.ros_packages import comes_with_ros

#: Topics on which nodes publish velocity commands, by package and executable.
_PUBLISHED = {
    ("twist_mux", "twist_mux"): "cmd_vel_out",
    ("teleop_twist_joy", "teleop_node"): "cmd_vel",
    ("teleop_twist_keyboard", "teleop_twist_keyboard"): "cmd_vel",
}
#: Packages whose nodes read no velocity commands, but for topics that their parameters name.
_OTHERS = re.compile(
    r"robot_state_publisher|joint_state_publisher(_gui)?|ros_gz_(sim|image|bridge)|rviz2|tf2_ros"
    r"|moveit_ros_move_group|slam_toolbox|robot_localization|controller_manager|twist_mux|joy"
    r"|teleop_twist_(joy|keyboard)|nav2_(?!velocity_smoother|collision_monitor)\w+"
)
_SMOOTHERS = ("nav2_velocity_smoother", "nav2_collision_monitor")
#: Topics of the smoothers, in the launch files of Nav2 and by default.
_SMOOTHED = ("/cmd_vel", "/cmd_vel_nav", "/cmd_vel_smoothed", "/cmd_vel_raw")
_DRIVE = re.compile(r"\w*(DiffDrive|Mecanum|OmniWheel|Tricycle|Steering)\w*Controller")
#: The parameter of a drive for the stamps of commands, and what their topic ends with without.
_STAMPED, _PLAIN = "use_stamped_vel", "_unstamped"
_COMMAND = re.compile(r"cmd_vel|reference")


def unread_commands(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Nodes whose velocity commands nothing reads."""
    sources = [
        (one, topic)
        for one in started
        if (name := _PUBLISHED.get((one.package, one.executable)))
        and (topic := topic_name(name, one))
    ]
    if not sources or is_included(context.source.path, context.resolver):
        return
    launches = (context.launch, *launches_of_workspace(context.source.path, context.resolver))
    programs = [one for launch in launches for one in (*launch.started, *launch.included)]
    if not all(map(_is_whole, launches)) or not all(map(_is_known, programs)):
        return
    defined = defined_controllers(context)
    spawned = [
        defined.get((word.text or "").strip("/")) for x in programs for word in controllers(x)
    ]
    if not all(one and one.kind for one in spawned):
        return  # others may read any topic
    if not all(are_all_known(robot.model) for _, robot in context.described_robots):
        return
    readers = dict(_readers(context, programs))
    read = {topic.removesuffix(_PLAIN) for topic in readers}
    if any(one.package in _SMOOTHERS for one in programs):
        read.update(_SMOOTHED)
    for one, topic in sources if readers else ():
        if topic.removesuffix(_PLAIN) not in read and not _is_named(topic, launches, context):
            other = nearest(topic, readers, 0) or next(iter(readers))
            yield Finding(
                Location(one.span, one.frame),
                f"'{one.executable}' publishes '{topic}', which nothing reads; velocity commands "
                f"are read on '{other}'",
                f"remap {topic} to {other}",
                related=(Related(readers[other], "their reader"),),
            )


def is_of_ros(path: str) -> bool:
    """True for an included file of ROS, which starts no robot."""
    return path.startswith(f"{UNKNOWN}/") and comes_with_ros(path.split("/")[2])


def _is_whole(launch: Launch) -> bool:
    return not launch.has_scopes and all(map(is_of_ros, launch.unread))


def _is_known(started: StartedProgram) -> bool:
    """True for a program of which it is known what velocity commands it reads."""
    if started.remappings is None or started.namespace is None:
        return False
    if started.package == MANAGER:  # gives its controllers the names
        renamed = " ".join(
            (*started.remappings, *(word.text or "cmd_vel" for word in started.words))
        )
        return _COMMAND.search(renamed) is None
    return started.package in _SMOOTHERS or bool(_OTHERS.fullmatch(started.package))


def _readers(context: Context, programs: Iterable[StartedProgram]) -> Iterator[tuple[str, Span]]:
    """Topics on which the bridge and the controllers of wheels read velocity commands."""
    defined = defined_controllers(context)
    for one in programs:
        for topic in bridged_topics(one, context.resolver):
            is_twist = topic.ros_type.endswith(("/Twist", "/TwistStamped"))
            name = topic_name(topic.ros_topic, one)
            if is_twist and topic.direction != FROM_GAZEBO and name:
                yield name, topic.span
        for word in controllers(one):
            controller = defined.get((word.text or "").strip("/"))
            kind = controller.type.rpartition("/")[2] if controller and controller.ros == 2 else ""
            if controller and _DRIVE.fullmatch(kind):
                own = "reference" if "Steering" in kind or "Mecanum" in kind else "cmd_vel"
                stamped = [one.text.lower() for one in controller.section.values(_STAMPED)]
                yield f"/{controller.name}/{own}{_PLAIN * ('false' in stamped)}", word.span


def _is_named(topic: str, launches: Iterable[Launch], context: Context) -> bool:
    """True if a parameter file may give the topic to a node that reads it."""
    written = re.compile(rb"(?<![\w/])/?%b(?![\w/])" % re.escape(topic.strip("/").encode()))
    paths = {file.path for launch in launches for file in launch.parameters}
    sources = filter(None, map(context.resolver.readable, paths))
    return any(written.search(source.data) for source in sources)
