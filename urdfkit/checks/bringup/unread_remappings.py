"""Remappings of topics that a node does not have: a controller has them, or they are reversed.

A controller runs in the controller manager: in ros2_control_node, or in Gazebo.

Sources: ros-controls/ros2_controllers#262 and #1246, ros-controls/ros2_control_demos#185, and
``spawner.py`` of ros2_control (humble to rolling).
"""

import re
from collections.abc import Iterable, Iterator

from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.checks.bringup.workspace_launches import robots_of_workspace, stock_key
from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import (
    MANAGER,
    resolve_name,
    spawned_controllers,
    spawns_controllers,
    topic_name,
)
from urdfkit.ros.node_parameters import NodeParameters, nodes_in_files
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.document import Element
from urdfkit.text.located_yaml import Value, mapping, scalar

#: The topic of a drive without stamps, and the parameter for it, up to Iron.
_UNSTAMPED, _STAMPED = "cmd_vel_unstamped", "use_stamped_vel"
#: The output of robot_localization, and its inputs of the same type.
_FILTERED, _ODOMETRY = "odometry/filtered", re.compile(r"odom\d+")
_OUTPUTS = {"robot_localization": _FILTERED, "twist_mux": "cmd_vel_out"}
#: Topics that every node may have, and those of image_transport.
_OF_ALL = re.compile(
    r"/(tf|tf_static|clock|rosout|parameter_events|diagnostics)$|/_|~"
    r"|/(compressed|compressedDepth|theora|zstd|ffmpeg)$"
)
#: Topics that drives have, and the end of the names of their classes.
_OF_DRIVES, _DRIVE = ("cmd_vel", "cmd_vel_unstamped", "odom", "odometry", "reference"), "Drive"
_MAX_NAMED = 5
#: How alike a suggested topic must be: ``odom`` is ``odometry/filtered``, but ``image`` no output.
_ALIKE = 0.3
_SPAWNERS = ("spawner", "spawner.py")
_HELP = (
    'pass --controller-ros-args "-r OLD:=NEW" to the spawner, or remap in ros2_control_node or in '
    "<ros> of Gazebo's plugin"
)


def unread_remappings(context: Context) -> Findings:
    """Remappings of controllers' topics in a spawner or in robot_state_publisher."""
    launch = context.launch
    spawned = {controller.word.text for controller in spawned_controllers(launch.programs)}
    for node in launch.started:
        for name in node.remappings or () if node.is_ros_2 else ():
            if spawns_controllers(node):
                is_unread = MANAGER not in name
            else:
                owner = name.strip("/").partition("/")[0]
                is_unread = node.package == "robot_state_publisher" and owner in spawned
            if is_unread:
                yield Finding(
                    node.at,
                    f"remapping of '{name}' has no effect: controllers run in the controller "
                    f"manager, not in '{node.executable}'",
                    _HELP,
                )


def remappings_of_plugins(robots: Iterable[Context]) -> Iterator[tuple[str, str, Element]]:
    """The remappings in ``<ros>`` of the control plugins of robots in Gazebo."""
    for robot in robots:
        for plugin in control_plugins(robot.model):
            for ros in plugin.at.all("ros"):
                for element in ros.all("remapping"):
                    old, _, new = element.text.strip().partition(":=")
                    yield old, new, element


def renamed_topics(context: Context) -> dict[str, str]:
    """The new full names of topics that control plugins of the workspace remap."""
    return {
        resolve_name(old, ""): resolve_name(new, "")
        for old, new, _ in remappings_of_plugins(robots_of_workspace(context))
    }


def unstamped_commands(context: Context) -> Findings:
    """Remappings of a topic that a drive has only without stamps, up to Iron."""
    defined = defined_controllers(context)
    for old, at in _renamed(context):
        name, _, topic = old.strip("/~").rpartition("/")
        controller = defined.get(name)
        if topic != _UNSTAMPED or controller is None or controller.ros != 2:
            continue
        stamped = {value.text.lower() for value in controller.section.values(_STAMPED)}
        if "false" not in stamped and "Drive" in controller.type:
            yield Finding(
                at,
                f"remapping of '{old}' has no effect: without {_STAMPED}: false, '{name}' reads "
                "TwistStamped on 'cmd_vel'",
                f"remap /{name}/cmd_vel, and publish TwistStamped; up to Iron, or set "
                f"{_STAMPED}: false",
            )


def unknown_controllers(context: Context) -> Findings:
    """Remappings of topics of a drive that is not there, while that of the robot has others."""
    drives = [name for name, one in defined_controllers(context).items() if _DRIVE in one.type]
    renamed = [(old, at, *_owner(old)) for old, at in _renamed(context)]
    for old, at, name, topic in renamed if len(drives) == 1 else ():
        served = {owner for _, _, owner, other in renamed if other == topic}
        if name and topic in _OF_DRIVES and served.isdisjoint(drives):
            yield Finding(
                at,
                f"remapping of '{old}' has no effect: no controller is called '{name}'"
                f"{did_you_mean(name, drives)}",
                f"remap /{drives[0]}/{topic}",
            )


def _owner(topic: str) -> tuple[str, str]:
    """The node in the full name of a topic, and the rest."""
    owner, _, name = topic.strip("/~").rpartition("/")
    return owner.rpartition("/")[2], name


def _renamed(context: Context) -> list[tuple[str, Location | Element]]:
    """The topics that the programs with controllers remap: Gazebo's plugin, ros2_control_node."""
    robots = (robot for _, robot in context.described_robots)
    renamed: list[tuple[str, Location | Element]] = [
        (old, element) for old, _, element in remappings_of_plugins(robots)
    ]
    for node in context.launch.started:
        if node.package == MANAGER and node.executable not in _SPAWNERS:
            renamed += ((old, node.at) for old in node.remappings or ())
    return renamed


def reversed_remappings(context: Context) -> Findings:
    """Remappings that rename another topic to the one that the node has."""
    for node in context.launch.started:
        own = {resolve_name(name, "") for name in _topics(node)}
        pairs = {resolve_name(old, ""): new for old, new in (node.remappings or {}).items()}
        for old, new in pairs.items() if node.is_ros_2 and node.namespace == "" else ():
            name = resolve_name(new, "")
            if name in own and name not in pairs and old not in own:
                yield Finding(
                    node.at,
                    f"remapping of '{old}' has no effect: the topic of '{node.executable}' is "
                    f"'{new}'",
                    f"remove it, or write it the other way round to read '{old}'",
                )


def unknown_topics(context: Context) -> Findings:
    """Remappings of topics that a node does not have, such as those of ROS 1."""
    for node in context.launch.started if not context.launch.has_scopes else ():
        topics = data("nodes")["all_topics"].get(stock_key(node, context), "").split()
        if not topics or not node.is_ros_2 or node.namespace is None:
            continue
        own = {resolve_name(topic, node.namespace): topic for topic in topics}
        for old in node.remappings or {}:
            name = resolve_name(old, node.namespace)
            new = resolve_name((node.remappings or {})[old], node.namespace)
            if new in own:
                continue  # the wrong way round
            if name in own or _OF_ALL.search(name) or not re.match(r"[\w/]", old):
                continue
            others = {resolve_name(other, node.namespace) for other in node.remappings or {}}
            free = [topic for full_name, topic in own.items() if full_name not in others]
            suggested = nearest(old.strip("/"), free or topics, _ALIKE)
            yield Finding(
                node.at,
                f"remapping of '{old}' has no effect: '{node.executable}' has the topics "
                f"{few(sorted(own), _MAX_NAMED)}",
                f"remap {suggested}" if suggested else "remap one of these topics, or remove it",
            )


def read_own_output(context: Context) -> Findings:
    """A filter of robot_localization, or twist_mux, whose output is renamed to an input."""
    for node in context.launch.started:
        written = _OUTPUTS.get(node.package, "")
        output = topic_name(written, node) if written else None
        files = node.parameters.files if output else ()
        for section in nodes_in_files(files, context.resolver):
            for key, value in _inputs(section) if section.are_of(node.name) else ():
                if resolve_name(value.text, node.namespace) == output:
                    yield Finding(
                        value.span,
                        f"'{section.name}' reads its own output: {key} is '{value.text}', and "
                        f"{written} is remapped to it",
                        f"remap {written} to another topic"
                        if written == _FILTERED
                        else "write another topic",
                        related=(Related(node.span, "the remapping is here"),),
                    )


def _inputs(section: NodeParameters) -> Iterator[tuple[str, Value]]:
    """The topics of odometry that a filter reads, and those of commands that twist_mux reads."""
    for key, value in section.values.items():
        if _ODOMETRY.fullmatch(key) and isinstance(value, Value):
            yield key, value
    for name, entry in mapping(section.values.get("topics")).items():
        if topic := scalar(entry, "topic"):
            yield f"topic of '{name}'", topic


def _topics(program: StartedProgram) -> list[str]:
    """The topics that a program has by default; empty for an unknown one."""
    nodes = data("nodes")
    topics: str = nodes["topics"].get(program.key) or nodes["all_topics"].get(program.key, "")
    return topics.split()
