"""Topics that a filter, a costmap or RViz reads and nothing publishes.

Reported only if all programs are known, and such messages are published on another topic.

Sources: ``ros_filter.cpp`` of robot_localization, ``obstacle_layer.cpp`` of nav2_costmap_2d, the
publishers of ros2_controllers (all of humble to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.checks.launch.defined_controllers import controllers_of_workspace
from urdfkit.checks.launch.rviz_displays import has_other_topics, read_by_rviz
from urdfkit.checks.launch.unread_remappings import renamed_topics
from urdfkit.core.record import Record
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.argument_checks import is_included
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.rviz import topic_of
from urdfkit.ros.launch.spawned_controllers import spawned_controllers, topic_name
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.text.located_yaml import Node, Value, mapping
from urdfkit.text.source import Span

#: Packages whose programs do not publish these messages.
_SILENT = re.compile(
    r"robot_state_publisher|joint_state_publisher(_gui)?|ros_gz_(sim|image)|rviz2|tf2_ros"
    r"|moveit_ros_move_group|slam_toolbox|nav2_(?!costmap_2d)\w+|joy|twist_mux"
    r"|teleop_twist_(joy|keyboard)"
)
_CONTROLLERS = "controller_manager"
#: robot_localization, and the topic that it publishes.
_FILTER, _FILTERED = "robot_localization", "odometry/filtered"
_OUTPUTS = {"odometry/filtered", "accel/filtered"}
_PUBLISHERS = (_CONTROLLERS, _FILTER, "ros_gz_bridge")
_SCAN_TOPIC = "scan_topic"
_INPUT = re.compile(r"(odom|imu)\d+")
_GRID = "OccupancyGrid"
_READ = {"odom": "Odometry", "imu": "Imu"}
#: A node whose sources are those of a costmap, and its words for messages.
_MONITOR = "collision_monitor"
_MONITORED = {"scan": "LaserScan", "pointcloud": "PointCloud2", "range": "Range"}
#: The displays of RViz that are named after their message.
_SHOWN = ("Image", "LaserScan", "Odometry", "PointCloud2")


class _ReadTopic(Record):
    """A topic that a node reads."""

    topic: str
    at: Span  # of the topic; of the node for a default
    message: str  # without its package
    who: str
    others: tuple[str, ...] = ()  # further topics of the same message; one of them is enough
    key: str = ""  # the parameter of a default


def unpublished_inputs(context: Context) -> Findings:
    topics = (*_read_by_nodes(context), *_read_by_defaults(context), *_read_by_rviz(context))
    inputs = [read for read in topics if not read.topic.startswith(("$", "~"))]
    if not inputs or is_included(context.source.path, context.resolver):
        return
    of_workspace = launches_of_workspace(context.source.path, context.resolver)
    filtered = {
        topic_name(_FILTERED, node)
        for launch in of_workspace
        for node in launch.programs
        if node.package == _FILTER
    }
    types = _bridged_types(context, of_workspace)
    for read in inputs:
        published = _publishers(context, of_workspace, read.message)
        name = "/" + read.topic.strip("/")
        names = {name, *(f"/{topic.strip('/')}" for topic in read.others)}
        if not published or names & published.keys() or names & filtered:
            continue
        if None in filtered and read.message == _READ["odom"]:
            continue
        if len(names) == 1 and name in types:
            yield _other_type(read, name, *types[name])
            continue
        other = nearest(name, published, 0) or next(iter(published))
        yield Finding(
            read.at,
            f"'{read.who}' waits for '{name}', which nothing publishes; {read.message} messages "
            f"are on '{other}'",
            f"set {read.key}: {other}" if read.key else f"write {other}",
            related=(Related(published[other].span, "the publisher is started here"),),
        )


def _other_type(read: _ReadTopic, name: str, message: str, at: Span) -> Finding:
    """A topic that is published with another message."""
    return Finding(
        read.at,
        f"'{read.who}' reads {read.message} from '{name}', where {message} is published",
        f"write {message} as its type, or name a topic of {read.message}",
        related=(Related(at, "it is published here"),),
    )


def _bridged_types(context: Context, launches: tuple[Launch, ...]) -> dict[str, tuple[str, Span]]:
    """The messages of the topics that bridges publish, and their places."""
    return {
        "/" + topic.ros_topic.strip("/"): (topic.ros_type.rpartition("/")[2], topic.span)
        for launch in launches
        for node in launch.programs
        for topic in bridged_topics(node, context.resolver)
        if topic.direction != TO_GAZEBO and not node.is_remapped
    }


def _publishers(
    context: Context, of_workspace: tuple[Launch, ...], message: str
) -> dict[str, StartedProgram]:
    """The topics on which a message is published; empty if a program may publish others.

    If this launch file starts no publisher of such messages, another may.
    """
    for launches in ((context.launch,), of_workspace):
        programs = [node for launch in launches for node in launch.programs]
        if published := dict(_published(context, programs, message)):
            has_scopes = any(launch.has_scopes for launch in launches)
            is_known = not has_scopes and all(_is_known(node, message) for node in programs)
            return published if is_known else {}
    return {}


def _is_known(program: StartedProgram, message: str) -> bool:
    """True if the topics on which a program publishes a message are known."""
    package = program.package
    is_other = package in (_CONTROLLERS, _FILTER) and message not in _READ.values()
    if is_other or _SILENT.fullmatch(package):
        return True
    is_remapped = program.is_remapped
    if package == _FILTER and program.remappings is not None:
        is_remapped = not {name.strip("/") for name in program.remappings} <= _OUTPUTS
    is_plain = program.is_sure and not is_remapped and program.namespace == ""
    return is_plain and package in _PUBLISHERS


def _read_by_rviz(context: Context) -> Iterator[_ReadTopic]:
    """Topics of RViz's displays, by message; some displays may be for other robots."""
    topics_by_message: dict[str, list[Value]] = {}
    for _, display, name in () if has_other_topics(context) else read_by_rviz(context):
        message = name.rpartition("/")[2]
        if message in _SHOWN and (topic := topic_of(display)):
            topics_by_message.setdefault(message, []).append(topic)
    for message, topics in topics_by_message.items():
        others = tuple(topic.text for topic in topics)
        yield _ReadTopic(topics[0].text, topics[0].span, message, "RViz", others)


def _read_by_nodes(context: Context) -> Iterator[_ReadTopic]:
    """Topics in parameter files."""
    inputs: dict[str, str] = data("nodes")["inputs"]
    for file in context.launch.parameters:
        source = context.resolver.readable(file.path)
        for node in node_parameters(source) if source else ():
            if node.name == _MONITOR:
                yield from _read_by_layer(node.values, node.name, "type")
            for key, value in node.values.items():
                if isinstance(value, dict):
                    yield from _read_by_layer(value, node.name)
                    map_topic = value.get("map_topic")
                    if isinstance(map_topic, Value) and map_topic.text:
                        yield _ReadTopic(map_topic.text, map_topic.span, _GRID, node.name)
                match = _INPUT.fullmatch(key) if f"{key}_config" in node.values else None
                message = _READ[match[1]] if match else inputs.get(f"{node.name}/{key}")
                if message and isinstance(value, Value):
                    yield _ReadTopic(value.text, value.span, message, node.name)


def _map_topic(program: StartedProgram, context: Context) -> str | None:
    """The topic on which a program publishes a map; None if it publishes none, or is unknown."""
    if program.package == "slam_toolbox":
        return topic_name("map", program)
    if (program.package, program.executable) != ("nav2_map_server", "map_server"):
        return None
    name = given_parameter(program, "topic_name", context.resolver)
    return None if name is None else topic_name(name or "map", program)


def _read_by_defaults(context: Context) -> Iterator[_ReadTopic]:
    """Topics that nodes of the file itself read because no parameter is given."""
    for program in context.launch.programs if not context.launch.has_scopes else ():
        is_own = program.frame is None and program.is_sure and program.remappings == {}
        topic = data("nodes")["defaults"].get(program.package, {}).get(_SCAN_TOPIC)
        is_read = topic and is_own and program.namespace == ""
        if is_read and given_parameter(program, _SCAN_TOPIC, context.resolver) == "":
            who = program.executable
            yield _ReadTopic(topic, program.span, "LaserScan", who, key=_SCAN_TOPIC)


def _read_by_layer(
    layer: dict[str, Node], who: str, key: str = "data_type"
) -> Iterator[_ReadTopic]:
    for source in layer.values() if "observation_sources" in layer else ():
        topic, message = mapping(source).get("topic"), mapping(source).get(key)
        if isinstance(topic, Value) and isinstance(message, Value):
            kind = _MONITORED.get(message.text, message.text)
            yield _ReadTopic(topic.text, topic.span, kind, who)


def _published(
    context: Context, programs: list[StartedProgram], message: str
) -> Iterator[tuple[str, StartedProgram]]:
    """Topics on which a message is published, and their publishers."""
    for node in programs:
        if message == _GRID and (topic_of_map := _map_topic(node, context)):
            yield topic_of_map, node
        for topic in bridged_topics(node, context.resolver):
            if topic.direction != TO_GAZEBO and topic.ros_type.endswith(f"/{message}"):
                yield "/" + topic.ros_topic.strip("/"), node
    spawned = list(spawned_controllers(programs))
    defined = controllers_of_workspace(context) if spawned else {}
    renamed = renamed_topics(context) if spawned else {}
    for controller in spawned:
        known = defined.get(controller.name)
        kind = known.type.rpartition("/")[2] if known else ""
        published, topic = data("nodes")["outputs"].get(kind, ("", ""))
        if published == message:
            name = f"/{controller.name}/{topic}"
            yield renamed.get(name, name), controller.program
