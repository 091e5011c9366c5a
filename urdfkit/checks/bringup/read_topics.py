"""Topics that nodes and RViz read, by the messages that they expect.

Sources: ``ros_filter.cpp`` of robot_localization, ``obstacle_layer.cpp`` of nav2_costmap_2d,
``costmap_filter_info_server.cpp`` of nav2_map_server (all of humble to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterator

from urdfkit.checks.bringup.rviz_displays import has_other_topics, read_by_rviz
from urdfkit.checks.bringup.workspace_launches import stock_key, workspace_launches
from urdfkit.core.record import Record
from urdfkit.lint.rules import Context, Location
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.cartographer import configurations
from urdfkit.ros.launch.contents import MOVEIT, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.rviz import topic_of
from urdfkit.ros.launch.spawned_controllers import resolve_name, topic_name
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Node, Value, load, mapping, scalar
from urdfkit.text.source import Span
from urdfkit.workspace.executables import program_of
from urdfkit.workspace.program_strings import sources_of_programs

GRID, FILTER_INFO = "OccupancyGrid", "CostmapFilterInfo"
#: The node that tells the filters of a costmap where their mask is, and its topics.
FILTER_SERVER = "costmap_filter_info_server"
INFO_TOPIC, _MASK_TOPIC = "filter_info_topic", "mask_topic"
_DEFAULT_TOPICS = {INFO_TOPIC: "/costmap_filter_info", _MASK_TOPIC: "/filter_mask"}
_SCAN_TOPIC = "scan_topic"
_INPUT = re.compile(r"(odom|imu)\d+")
_MESSAGES = {"odom": "Odometry", "imu": "Imu"}
#: A node whose sources are those of a costmap, and its words for messages.
_MONITOR = "collision_monitor"
_MONITORED = {"scan": "LaserScan", "pointcloud": "PointCloud2", "range": "Range"}
#: Topics of a sensor for the octomap, by parameter.
_OF_SENSORS = {"point_cloud_topic": "PointCloud2", "image_topic": "Image"}
_YAML = (".yaml", ".yml")
#: The displays of RViz that are named after their message.
_SHOWN = ("Image", "LaserScan", "Odometry", "PointCloud2")


#: A subscription with literals, and its messages that other programs and sensors publish.
_SUBSCRIBES = re.compile(rb"create_subscription\(\s*(\w+),\s*[\"']([\w/]+)[\"']")
_OF_PROGRAMS = (*_SHOWN, "Imu")


class ReadTopic(Record):
    """A topic that a node reads."""

    topic: str
    at: Span | Location  # of the topic; of the node for a default
    message: str  # without its package
    who: str
    others: tuple[str, ...] = ()  # further topics of the same message; one of them is enough
    instruction: str = "write "  # the start of the help, before another topic
    is_of_workspace: bool = False  # True if any launch file may start the publisher
    is_of_program: bool = False  # True for a topic in the source of a program of the workspace
    switch: str = ""  # the parameter without which the node does not read the topic


def read_topics(context: Context) -> Iterator[ReadTopic]:
    """The topics that the nodes of a launch file read, and RViz."""
    yield from _read_by_nodes(context)
    yield from _read_by_defaults(context)
    yield from _read_by_programs(context)
    yield from _read_by_own_programs(context)
    yield from _read_by_cartographer(context)
    yield from _read_by_move_group(context)
    yield from _read_by_rviz(context)


def read_in_other_files(context: Context) -> Iterator[ReadTopic]:
    """The topics in files other than parameter files; any launch file may start the publisher."""
    for read in (*_read_by_move_group(context), *_read_by_rviz(context)):
        yield read._replace(is_of_workspace=True)


def _read_by_nodes(context: Context) -> Iterator[ReadTopic]:
    """Topics in parameter files."""
    inputs: dict[str, str] = data("nodes")["inputs"]
    paths = (file.path for file in context.launch.parameters)
    for node in nodes_in_files(paths, context.resolver):
        if node.name == _MONITOR:
            yield from _read_by_layer(node.values, node.name, "type")
        for key, value in node.values.items():
            if isinstance(value, dict):
                yield from _read_by_layer(value, node.name)
                yield from _read_by_filter(value, node.name)
                map_topic = scalar(value, "map_topic")
                if map_topic and map_topic.text:
                    yield ReadTopic(map_topic.text, map_topic.span, GRID, node.name)
            match = _INPUT.fullmatch(key) if f"{key}_config" in node.values else None
            message = _MESSAGES[match[1]] if match else inputs.get(f"{node.name}/{key}")
            if message and isinstance(value, Value):
                yield ReadTopic(value.text, value.span, message, node.name)


def _read_by_defaults(context: Context) -> Iterator[ReadTopic]:
    """Topics that nodes of the file itself read because no parameter is given."""
    for program in context.launch.programs if not context.launch.has_scopes else ():
        is_own = program.frame is None and program.is_sure and program.remappings == {}
        topic = data("nodes")["defaults"].get(program.package, {}).get(_SCAN_TOPIC)
        is_read = topic and is_own and program.namespace == ""
        if is_read and given_parameter(program, _SCAN_TOPIC, context.resolver) == "":
            who = program.executable
            instruction = f"set {_SCAN_TOPIC}: "
            yield ReadTopic(topic, program.span, "LaserScan", who, instruction=instruction)


def _read_by_programs(context: Context) -> Iterator[ReadTopic]:
    """Topics that nodes read by default, with their remappings."""
    for program in context.launch.programs if not context.launch.has_scopes else ():
        if not program.is_sure:
            continue
        read = data("nodes")["readers"].get(stock_key(program, context), {})
        for topic, facts in read.items():
            message, *conditions = facts.split()
            name = topic_name(topic, program)
            if name and all(_holds(condition, program, context) for condition in conditions):
                switch = next((text.partition("=")[0] for text in conditions if "=" in text), "")
                instruction = f"remap {topic} to "
                at = program.at
                yield ReadTopic(
                    name, at, message, program.title, instruction=instruction, switch=switch
                )
        if program.executable == FILTER_SERVER:
            mask = topic_parameter(program, _MASK_TOPIC, context)
            instruction = f"set {_MASK_TOPIC}: "
            if mask:
                read_mask = ReadTopic(
                    mask, program.at, GRID, program.title, instruction=instruction
                )
                yield read_mask._replace(is_of_workspace=True)


def _read_by_own_programs(context: Context) -> Iterator[ReadTopic]:
    """Topics that Python programs of the workspace read."""
    near, resolver = context.source.path, context.resolver
    known = resolver.packages.known(near)
    for program in context.launch.programs if not context.launch.has_scopes else ():
        directory = known.get(program.package) if program.is_sure else None
        path = program_of(directory, program.package, program.executable) if directory else ""
        source = resolver.readable(path) if path else None
        for match in _SUBSCRIBES.finditer(source.data) if source else ():
            message, topic = (part.decode() for part in match.groups())
            name = topic_name(topic, program)
            if source and name and message in _OF_PROGRAMS:
                is_renamed = name != resolve_name(topic, "")
                at = program.at if is_renamed else Span(source, match.start(2), match.end(2))
                instruction = f"remap {topic} to " if is_renamed else "write "
                yield ReadTopic(
                    name, at, message, program.title, instruction=instruction, is_of_program=True
                )


def is_named_by_another(read: ReadTopic, context: Context) -> bool:
    """True if another program of the workspace names what a program reads: it may publish it."""
    own = read.at.source.path if isinstance(read.at, Span) else ""
    quoted = re.compile(rb"[\"'/]%b[\"']" % re.escape(read.topic.strip("/").encode()))
    packages = context.resolver.packages.known(context.source.path)
    return any(
        source.path != own and quoted.search(source.data)
        for package in packages
        for source in sources_of_programs(package, context.source.path, context.resolver)
    )


def _read_by_cartographer(context: Context) -> Iterator[ReadTopic]:
    programs = context.launch.programs if not context.launch.has_scopes else ()
    for configuration in configurations(programs, context.resolver):
        program = configuration.program
        for topic, message in configuration.inputs if program.is_sure else ():
            if name := topic_name(topic, program):
                instruction = f"remap {topic} to "
                if topic[-1].isdigit() and topic != "points2":
                    instruction = (
                        f"set the number of inputs in {configuration.name.text}, or {instruction}"
                    )
                yield ReadTopic(name, program.at, message, program.title, instruction=instruction)


def _read_by_move_group(context: Context) -> Iterator[ReadTopic]:
    """Topics of sensors for the octomap of move_group."""
    paths = {file.path for file in context.launch.files if file.purpose == MOVEIT and file.exists}
    for path in sorted(path for path in paths if path.endswith(_YAML)):
        source = context.resolver.readable(path)
        is_of_sensors = source is not None and b"sensor_plugin" in source.data
        for section in mapping(load(source)).values() if source and is_of_sensors else ():
            for key, message in _OF_SENSORS.items() if mapping(section) else ():
                if (topic := scalar(section, key)) and topic.text:
                    yield ReadTopic(topic.text, topic.span, message, "move_group")


def _holds(condition: str, program: StartedProgram, context: Context) -> bool:
    """Whether a condition certainly holds.

    ``name=default`` must be true, ``-name`` not given, and ``!name`` false or not given; ``ros2``
    is the version.
    """
    if condition == "ros2":
        return program.is_ros_2
    name, _, default = condition.lstrip("-!").partition("=")
    value = given_parameter(program, name, context.resolver)
    if condition.startswith("-"):
        return value == ""
    if condition.startswith("!"):
        return value is not None and value.lower() in ("", "false")
    return value is not None and (value or default).lower() == "true"


def _read_by_filter(section: dict[str, Node], who: str) -> Iterator[ReadTopic]:
    """The topic from which a filter of a costmap learns of its mask."""
    topic = scalar(section, INFO_TOPIC)
    if topic and "plugin" in section:
        # A relative name is in the namespace of the costmap up to Jazzy.
        others = (f"{who}/{topic.text}",)
        yield ReadTopic(topic.text, topic.span, FILTER_INFO, who, others, is_of_workspace=True)


def _read_by_layer(layer: dict[str, Node], who: str, key: str = "data_type") -> Iterator[ReadTopic]:
    for source in layer.values() if "observation_sources" in layer else ():
        topic, message = scalar(source, "topic"), scalar(source, key)
        if topic and message:
            kind = _MONITORED.get(message.text, message.text)
            yield ReadTopic(topic.text, topic.span, kind, who)


def _read_by_rviz(context: Context) -> Iterator[ReadTopic]:
    """Topics of RViz's displays, by message; some displays may be for other robots."""
    topics_by_message: dict[str, list[Value]] = {}
    paths: set[str] = set()
    for file, display, name in () if has_other_topics(context) else read_by_rviz(context):
        message = name.rpartition("/")[2]
        if message in _SHOWN and (topic := topic_of(display)):
            topics_by_message.setdefault(message, []).append(topic)
            paths.add(file.path)
    is_shared = any(_is_shared(path, context) for path in paths)
    for message, shown in topics_by_message.items():
        others = tuple(topic.text for topic in shown)
        read = ReadTopic(shown[0].text, shown[0].span, message, "RViz", others)
        yield read._replace(is_of_workspace=is_shared)


def _is_shared(path: str, context: Context) -> bool:
    """True if several launch files start RViz with a configuration."""
    launches = workspace_launches(context)
    return sum(any(file.path == path for file in launch.files) for launch in launches) > 1


def topic_parameter(program: StartedProgram, name: str, context: Context) -> str | None:
    """The topic that a parameter of costmap_filter_info_server names; None if unknown."""
    value = given_parameter(program, name, context.resolver)
    return None if value is None else topic_name(value or _DEFAULT_TOPICS[name], program)
