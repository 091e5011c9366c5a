"""Topics that a filter, a costmap or RViz reads and nothing publishes.

Reported only if all programs are known, and such messages are published on another topic.

Sources: ``ros_filter.cpp`` of robot_localization, the publishers of ros2_controllers (all of humble
to rolling).
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from posixpath import basename, dirname

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.processes import is_silent_process
from urdfkit.checks.bringup.read_topics import (
    FILTER_INFO,
    FILTER_SERVER,
    GRID,
    INFO_TOPIC,
    ReadTopic,
    is_named_by_another,
    read_in_other_files,
    read_topics,
    topic_parameter,
)
from urdfkit.checks.bringup.rviz_displays import has_other_topics, read_by_rviz
from urdfkit.checks.bringup.spawned_topics import SpawnedTopics, spawned_topics
from urdfkit.checks.bringup.unbridged_sensors import (
    sensors_of_workspace,
    unbridged,
    unbridged_sensor,
)
from urdfkit.checks.bringup.unloaded_hardware import CONTROL_NODE
from urdfkit.checks.bringup.unread_remappings import renamed_topics
from urdfkit.checks.bringup.workspace_launches import (
    is_included,
    programs_of,
    stock_key,
    workspace_launches,
)
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.cartographer import CARTOGRAPHER
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter, topic_of_program
from urdfkit.ros.launch.rviz import topic_of
from urdfkit.ros.launch.spawned_controllers import spawned_controllers, topic_name
from urdfkit.text.located_yaml import Node, scalar
from urdfkit.text.source import Span
from urdfkit.workspace.program_strings import may_publish

#: Packages whose programs do not publish these messages.
_SILENT = re.compile(
    r"robot_state_publisher|joint_state_publisher(_gui)?|ros_gz_sim|rviz2|tf2_ros"
    r"|moveit_ros_move_group|slam_toolbox|nav2_(?!costmap_2d)\w+|joy|twist_(mux|stamper)"
    r"|teleop_twist_(joy|keyboard)"
)
_CONTROLLERS = "controller_manager"
#: robot_localization, and the topic that it publishes.
_FILTER, _FILTERED = "robot_localization", "odometry/filtered"
_OUTPUTS = frozenset(("odometry/filtered", "accel/filtered"))
_READ_BY_MANAGER = frozenset(("robot_description",))
#: The nodes of Nav2 that read odometry, of the filter if there is one.
_OF_NAVIGATION = ("bt_navigator", "controller_server", "velocity_smoother")
#: The node of robot_localization that reads the position of a satellite receiver, and its output.
_NAVSAT, _OF_NAVSAT = "navsat_transform_node", "odometry/gps"
_TOPICS_OF_NAVSAT = frozenset(
    ("imu", "gps/fix", "odometry/filtered", "odometry/gps", "gps/filtered")
)
_BRIDGES = ("ros_gz_bridge", "ros_gz_image")
_PUBLISHERS = (_CONTROLLERS, _FILTER)
#: Most topics that are named as likely in place of one.
_MOST_ALIKE = 3
_ODOMETRY, _IMU, _SCAN = "Odometry", "Imu", "LaserScan"
#: Topics of programs of robot_localization, and the start of the help.
_STARTED = {
    "odometry/gps": f"start {_NAVSAT}, or ",
    "odometry/filtered": "start robot_localization, or ",
}


def unpublished_inputs(context: Context) -> Findings:
    # The including files know the parameters of an included one, but not what else it reads.
    found = read_in_other_files(context) if is_included(context) else read_topics(context)
    inputs = [read for read in found if not read.topic.startswith(("$", "~"))]
    if not inputs:
        return
    of_workspace = workspace_launches(context)
    filtered = _outputs_of_filters((context.launch, *of_workspace))
    spawned = spawned_topics(context, (context.launch, *of_workspace))
    served: dict[str, str] = {}  # the directories of the topics that nodes get, by node
    waiting: list[tuple[ReadTopic, dict[str, StartedProgram]]] = []
    for read in inputs:
        published = _publishers_for(read, context, of_workspace, spawned)
        names = _names(read)
        if published and names & (published.keys() | filtered):
            served.setdefault(read.who, dirname(_absolute(read.topic)))
        elif published is not None and not names & filtered:
            may_be_filtered = None in filtered and read.message == _ODOMETRY
            waiting += (
                [] if may_be_filtered or _is_of_others(read, context) else [(read, published)]
            )
    types = _bridged_types(context, of_workspace) if waiting else {}
    sensors = sensors_of_workspace(context, of_workspace) if waiting else []
    directories = dict(served)
    reported: set[str] = set()
    for read, published in waiting:
        name = _absolute(read.topic)
        sensor = None if name in types else unbridged_sensor(sensors, read, published)
        if sensor and sensor.who not in reported:
            yield unbridged(read, name, sensor)
            reported.add(sensor.who)
        elif _of_others(read, published) and not sensor:
            if name in types and len(_names(read)) == 1:
                yield from _other_type(read, *types[name])
            else:
                others = _other_topics(read, published, directories.get(read.who))
                directories.setdefault(read.who, dirname(others[0]))
                of_filters = sorted(filter(None, filtered)) if read.who in _OF_NAVIGATION else []
                yield _on_other(read, [*of_filters, *others], published[others[0]])
        elif read.switch and read.who in served and not sensor:
            yield Finding(
                read.at,
                f"'{read.who}' waits for {read.message} messages on '{name}', which nothing "
                "publishes",
                f"set {read.switch}: false",
            )


def unpublished_scans(context: Context) -> Findings:
    """One of several displays of scans in RViz, while another scan is published and not shown."""
    displays = [] if has_other_topics(context) or is_included(context) else read_by_rviz(context)
    scans = [display for _, display, kind in displays if kind.endswith(f"/{_SCAN}")]
    shown = [topic for display in scans if (topic := topic_of(display)) and _is_enabled(display)]
    if len(shown) < 2:  # see unpublished_inputs
        return
    of_workspace = workspace_launches(context)
    spawned = spawned_topics(context, (context.launch, *of_workspace))
    published = _publishers(context, (context.launch,), of_workspace, _SCAN, spawned) or {}
    names = {_absolute(topic.text) for topic in shown}
    free = [name for name in published if name not in names]
    for topic in shown if free and not names.isdisjoint(published) else ():
        if (name := _absolute(topic.text)) not in published:
            other = nearest(name, free, 0) or free[0]
            yield Finding(
                topic.span,
                f"RViz shows '{name}', which nothing publishes; {_SCAN} messages are on '{other}'",
                f"write {other}",
                related=(Related(published[other].span, "the publisher is started here"),),
            )


def _is_enabled(display: dict[str, Node]) -> bool:
    switch = scalar(display, "Enabled")
    return switch is None or switch.boolean is not False


def _names(read: ReadTopic) -> set[str]:
    """The topics of which a node reads one."""
    return {_absolute(topic) for topic in (read.topic, *read.others)}


def _absolute(topic: str) -> str:
    return "/" + topic.strip("/")


def _outputs_of_filters(launches: tuple[Launch, ...]) -> set[str | None]:
    """The topics that robot_localization publishes; None among them if one is unknown."""
    return {
        topic_name(_OF_NAVSAT if node.executable == _NAVSAT else _FILTERED, node)
        for node in programs_of(launches)
        if node.package == _FILTER
    }


def _of_others(read: ReadTopic, published: dict[str, StartedProgram]) -> list[str]:
    """The topics that other nodes publish; none if all convert messages of unknown publishers."""
    at = read.at.span if isinstance(read.at, Location) else read.at
    if all(map(_is_converter, published.values())):
        return []
    return [topic for topic, node in published.items() if node.span != at]


def _other_topics(
    read: ReadTopic, published: dict[str, StartedProgram], directory: str | None
) -> list[str]:
    """The topic that is most likely meant, and others that are as likely.

    An image and its camera's info are in one directory. Instead of `/scan`, a robot with two lidars
    has `/front_scan` and `/rear_scan`.
    """
    others = _of_others(read, published)
    others = [topic for topic in others if dirname(topic) == directory] or others
    name = _absolute(read.topic)
    likely = nearest(name, others, 0) or others[0]
    words = set(basename(name).split("_"))
    longer = [topic for topic in others if words < set(basename(topic).split("_"))]
    alike = longer if likely in longer and len(longer) <= _MOST_ALIKE else []
    return [likely, *(topic for topic in alike if topic != likely)]


def _on_other(read: ReadTopic, others: list[str], publisher: StartedProgram) -> Finding:
    """A topic that nothing publishes, while such messages are on another one."""
    name = _absolute(read.topic)
    named = " and ".join(f"'{other}'" for other in others)
    return Finding(
        read.at,
        f"'{read.who}' waits for '{name}', which nothing publishes; {read.message} messages "
        f"are on {named}",
        f"{_STARTED.get(name.strip('/'), '')}{read.instruction}{' or '.join(others)}",
        related=(Related(publisher.span, "the publisher is started here"),),
    )


def _other_type(read: ReadTopic, message: str, at: Span) -> Findings:
    """A topic that is published with another message."""
    if message != read.message:
        yield Finding(
            read.at,
            f"'{read.who}' reads {read.message} from '{_absolute(read.topic)}', where {message} is "
            "published",
            f"write {message} as its type, or name a topic of {read.message}",
            related=(Related(at, "it is published here"),),
        )


def _bridged_types(context: Context, launches: tuple[Launch, ...]) -> dict[str, tuple[str, Span]]:
    """The messages of the topics that bridges publish, and their places."""
    return {
        _absolute(topic.ros_topic): (topic.ros_type.rpartition("/")[2], topic.span)
        for launch in launches
        if not _has_other_robot(launch, context)
        for node in launch.programs
        for topic in bridged_topics(node, context.resolver)
        if topic.direction != TO_GAZEBO and not node.is_remapped
    }


def _is_of_others(read: ReadTopic, context: Context) -> bool:
    """True for a topic of a program that another program may publish, though nothing starts it."""
    return read.is_of_program and is_named_by_another(read, context)


def _publishers_for(
    read: ReadTopic, context: Context, of_workspace: tuple[Launch, ...], spawned: SpawnedTopics
) -> dict[str, StartedProgram] | None:
    """As below; None also for a program whose launch file starts no sensor: it may have another."""
    own = (context.launch,)
    if read.is_of_program and not any(_published(context, programs_of(own), read.message, spawned)):
        return None
    started = () if read.is_of_workspace else own
    return _publishers(context, started, of_workspace, read.message, spawned)


def _publishers(
    context: Context,
    started: tuple[Launch, ...],
    of_workspace: tuple[Launch, ...],
    message: str,
    spawned: SpawnedTopics,
) -> dict[str, StartedProgram] | None:
    """The topics on which a message is published; None if a program may publish others.

    If this launch file starts no publisher of such messages, another may.
    """
    for launches in (started, of_workspace):
        programs = programs_of(launches)
        published = dict(_published(context, programs, message, spawned))
        if not all(map(_is_converter, published.values())) or launches is of_workspace:
            has_scopes = any(launch.has_scopes for launch in launches)
            is_known = not has_scopes and all(
                node.span in spawned
                or _is_known(node, message, context)
                or not may_publish(node.package, message, context.source.path, context.resolver)
                for node in programs
            )
            related = (launch for launch in of_workspace if not _has_other_robot(launch, context))
            others = dict(_published(context, programs_of(related), message, spawned))
            return published | others if is_known else None
    return None


def _has_other_robot(launch: Launch, context: Context) -> bool:
    """True if a launch file starts another robot than this one."""
    own, others = (
        {description.path for description in one.descriptions} for one in (context.launch, launch)
    )
    return bool(own and others) and own.isdisjoint(others)


def _is_known(program: StartedProgram, message: str, context: Context) -> bool:
    """True if the topics on which a program publishes a message are known."""
    package = program.package
    is_other = package in (_CONTROLLERS, _FILTER) and message not in (_ODOMETRY, _IMU)
    published = _publications(program, context)
    if published is not None:
        names = [name for name, messages in published.items() if message in messages.split()]
        is_named = program.remappings is not None and program.namespace is not None
        return not names or ("*" not in names and is_named and program.is_sure)
    if is_other or _SILENT.fullmatch(package) or is_silent_process(program):
        return True
    if package == _CONTROLLERS and _spawns_others(program, message, context):
        return True
    renamed = program.remappings
    if package in _BRIDGES:
        return program.is_sure and renamed is not None and program.namespace is not None
    known = {_CONTROLLERS: _READ_BY_MANAGER, _FILTER: _OUTPUTS}.get(package, frozenset())
    if program.executable == _NAVSAT:
        known = _TOPICS_OF_NAVSAT
    is_remapped = renamed is None or not {name.strip("~/") for name in renamed} <= known
    is_placed = program.namespace == "" and package in _PUBLISHERS
    # What a controller manager publishes depends on the spawners, which have their own conditions.
    is_sure = program.is_sure or program.executable == CONTROL_NODE
    return is_sure and not is_remapped and is_placed


def _spawns_others(program: StartedProgram, message: str, context: Context) -> bool:
    """True if no controller that a spawner loads publishes a message."""
    defined = controllers_of_workspace(context)
    known = [defined.get(controller.name) for controller in spawned_controllers([program])]
    outputs = data("nodes")["outputs"]
    return bool(known) and all(
        one and outputs.get(one.type.rpartition("/")[2], ("", ""))[0] != message for one in known
    )


def _publications(program: StartedProgram, context: Context) -> dict[str, str] | None:
    """The topics and messages of a program in the catalogue; None if it is not there."""
    published: dict[str, str] | None = data("nodes")["publishers"].get(stock_key(program, context))
    return published


def _is_converter(program: StartedProgram) -> bool:
    """True for a program that publishes what it makes of other messages."""
    return program.key in (CARTOGRAPHER, *data("nodes")["readers"])


def _topics_of(program: StartedProgram, message: str, context: Context) -> Iterator[str]:
    """The topics on which a program in the catalogue publishes a message."""
    for name, messages in (_publications(program, context) or {}).items():
        is_named = message in messages.split() and name != "*"
        topic = topic_of_program(program, name, context.resolver) if is_named else None
        if topic:
            yield topic


def _map_topic(program: StartedProgram, context: Context) -> str | None:
    """The topic on which a program publishes a map; None if it publishes none, or is unknown."""
    if program.package == "slam_toolbox":
        return topic_name("map", program)
    if program.key != "nav2_map_server/map_server":
        return None
    name = given_parameter(program, "topic_name", context.resolver)
    return None if name is None else topic_name(name or "map", program)


def _topic_of_map(program: StartedProgram, message: str, context: Context) -> str | None:
    """The topic of a map, or of what tells the filters of a costmap about it."""
    if message == GRID:
        return _map_topic(program, context)
    is_server = program.executable == FILTER_SERVER and message == FILTER_INFO
    return topic_parameter(program, INFO_TOPIC, context) if is_server else None


def _published(
    context: Context, programs: list[StartedProgram], message: str, spawned: SpawnedTopics
) -> Iterator[tuple[str, StartedProgram]]:
    """Topics on which a message is published, and their publishers."""
    for node in programs:
        for of_robot in spawned.get(node.span, ()):
            if of_robot.message == message:
                yield of_robot.name, node
        if topic_of_map := _topic_of_map(node, message, context):
            yield topic_of_map, node
        for name in _topics_of(node, message, context):
            yield name, node
        for topic in bridged_topics(node, context.resolver):
            is_published = topic.direction != TO_GAZEBO and topic.ros_type.endswith(f"/{message}")
            if is_published and (name_of_bridged := topic_name(topic.ros_topic, node)):
                yield name_of_bridged, node
    controllers = list(spawned_controllers(programs))
    defined = controllers_of_workspace(context) if controllers else {}
    renamed = renamed_topics(context) if controllers else {}
    for controller in controllers:
        known = defined.get(controller.name)
        kind = known.type.rpartition("/")[2] if known else ""
        published, topic = data("nodes")["outputs"].get(kind, ("", ""))
        if published == message:
            name = f"/{controller.name}/{topic}"
            yield renamed.get(name, name), controller.program
