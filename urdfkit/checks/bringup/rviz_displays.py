"""Displays of RViz that stay empty: unknown classes, unpublished topics, missing meshes.

Sources: plugins_description.xml of rviz_default_plugins and retriever.cpp of resource_retriever,
Humble to Rolling; kobuki-base/kobuki_ros#51.
"""

import os
import re
from collections.abc import Iterator

from urdfkit.checks.bringup.unread_commands import is_part_of_ros
from urdfkit.checks.bringup.workspace_launches import all_launches, stock_key, workspace_launches
from urdfkit.core.suggest import TYPO, is_typo, nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.contents import FileUse, Launch, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter, topic_of_program
from urdfkit.ros.launch.rviz import displays, other_classes, tools, topic_of
from urdfkit.ros.launch.spawned_controllers import resolve_name, topic_name
from urdfkit.text.located_yaml import Node, Value, scalar
from urdfkit.text.source import Source, Span

_PLUGINS, _POLICY = "rviz_default_plugins", "Reliability Policy"
#: The topic of goals in ROS 1.
_OLD_GOAL = "move_base_simple/goal"
#: Beginnings of the names of packages whose programs publish no messages of sensors.
_NO_SENSORS = ("joint_state_publisher", "nav2_", "robot_state_", "rviz2", "slam_toolbox", "tf2_ros")
#: The topics of tools that Nav2 reads.
_READ_BY_NAV2 = {"SetGoal": "goal_pose", "SetInitialPose": "initialpose"}


def read_by_rviz(context: Context) -> Iterator[tuple[FileUse, dict[str, Node], str]]:
    """The displays in the configurations of RViz in ROS 2: the file, the display, its class."""
    for file, source in configurations(context):
        for display in displays(source):
            kind = scalar(display, "Class")
            if kind:
                yield file, display, kind.text


def configurations(context: Context) -> Iterator[tuple[FileUse, Source]]:
    """The configurations of RViz in ROS 2, each once."""
    is_started = any(node.package == "rviz2" for node in context.launch.started)
    files = {file.path: file for file in reversed(context.launch.files) if is_started}
    for path, file in reversed(files.items()):
        source = context.resolver.readable(path) if path.endswith(".rviz") and file.exists else None
        if source:
            yield file, source


def has_other_topics(context: Context) -> bool:
    """True if RViz has a namespace or remappings, which change the names of its topics."""
    return any(
        node.package == "rviz2" and (node.is_remapped or node.namespace != "")
        for node in context.launch.started
    )


def unknown_classes(context: Context) -> Findings:
    """Display classes of RViz in ROS 1, and misspelt classes."""
    reported: set[str] = set()
    displays = data("rviz")["displays"].split()
    for file, display, name in read_by_rviz(context):
        package, _, kind = name.partition("/")
        suggested = kind if kind in displays else nearest(kind, displays, TYPO)
        is_known = package not in ("rviz", _PLUGINS) or name == f"{_PLUGINS}/{suggested}"
        class_name = display["Class"]
        if is_known or not suggested or name in reported or not isinstance(class_name, Value):
            continue
        reported.add(name)
        message, help = f"RViz has no display '{name}'", f"write {_PLUGINS}/{suggested}"
        yield _finding(class_name.span, message, help, file)
    yield from _misspelt_parts(context)


def _misspelt_parts(context: Context) -> Findings:
    """Panels, tools and views whose package has a class of almost the same name."""
    for file, source in configurations(context):
        for name in other_classes(source):
            package, _, kind = name.text.partition("/")
            known: list[str] = data("rviz")["others"].get(package, [])
            same = {_plain(other): other for other in known}
            suggested = same.get(_plain(kind)) or nearest(kind, known, TYPO)
            if suggested and kind not in known:
                message, help = f"RViz has no '{name.text}'", f"write {package}/{suggested}"
                yield _finding(name.span, message, help, file)


def _plain(name: str) -> str:
    return re.sub(r"\W", "", name).lower()


def volatile_maps(context: Context) -> Findings:
    """Displays of the map that miss it: map_server publishes it once, for late subscribers, too."""
    servers = [node for node in context.launch.programs if node.executable == "map_server"]
    topics = {topic_name("map", node) for node in servers}  # slam_toolbox repeats the map
    if context.launch.has_scopes or "/map" not in topics:
        return
    for file, display, name in read_by_rviz(context):
        durability = scalar(display, "Topic", "Durability Policy")
        topic = topic_of(display)
        is_map = name.endswith("/Map") and topic is not None and topic.text.strip("/") == "map"
        if is_map and durability and durability.text == "Volatile":
            message = "Map of RViz misses a map that was published before it started"
            yield _finding(durability.span, message, "write Transient Local", file)


def incompatible_reliability(context: Context) -> Findings:
    """Displays that require reliable topics which a node publishes as best effort."""
    if has_other_topics(context):
        return
    published: dict[str, Span] = {}
    own = context.launch
    for launch in (own,) if _may_start_sensors(own) else all_launches(context):
        for node in launch.programs if not launch.has_scopes else ():
            for topic in _best_effort(node, context):
                published.setdefault(topic, node.span)
    for file, display, kind in read_by_rviz(context) if published else ():
        policy, topic_of_display = scalar(display, "Topic", _POLICY), topic_of(display)
        at = published.get(resolve_name(topic_of_display.text, "")) if topic_of_display else None
        if at and policy and policy.text == "Reliable":
            message = f"{kind.rpartition('/')[2]} of RViz gets no messages: they are best effort"
            note = Related(at, "the publisher is started here")
            finding = _finding(policy.span, message, "write Best Effort", file)
            yield finding._replace(related=(*finding.related, note))


def _may_start_sensors(launch: Launch) -> bool:
    """False for a launch file whose RViz shows the sensors that other launch files start."""
    are_known = all(node.package.startswith(_NO_SENSORS) for node in launch.programs)
    return not are_known or not all(map(is_part_of_ros, launch.unread))


def _best_effort(program: StartedProgram, context: Context) -> Iterator[str]:
    """The topics that a program certainly publishes without reliability.

    Of drivers of which an argument chooses one, others may be reliable.
    """
    if not program.is_sure:
        return
    facts = data("nodes")["best_effort"].get(stock_key(program, context), "")
    names = facts.split()
    switches = [name[1:] for name in names if name.startswith("-")]
    given = [given_parameter(program, switch, context.resolver) for switch in switches]
    for name in names if all(text == "" for text in given) else ():
        topic = topic_of_program(program, name, context.resolver)
        if topic and not name.startswith("-"):
            yield topic


def unread_goals(context: Context) -> Findings:
    """Tools of RViz whose topics Nav2, which is started, does not read: of ROS 1, misspelt."""
    if not any(node.package.startswith("nav2_") for node in context.launch.programs):
        return
    if has_other_topics(context):
        return
    for file in context.launch.files:
        source = context.resolver.readable(file.path) if file.path.endswith(".rviz") else None
        for tool in tools(source) if source else ():
            kind, topic = scalar(tool, "Class"), topic_of(tool)
            if kind is None or topic is None:
                continue
            class_name, name = kind.text.rpartition("/")[2], topic.text.strip("/")
            right = _READ_BY_NAV2.get(class_name, name)
            if name == _OLD_GOAL or (name != right and is_typo(name, right)):
                message = f"{class_name} of RViz publishes '{topic.text}', which Nav2 does not read"
                yield _finding(topic.span, message, f"write /{right}", file)


def unpublished_models(context: Context, published: dict[str, Span]) -> Findings:
    """RobotModel displays that read the robot from a topic on which nothing publishes it.

    Args:
        published: the topics of the robots, and their publishers.
    """
    if has_other_topics(context):
        return
    displays = list(read_by_rviz(context))
    shown = {(file.path, _described(display)) for file, display, _ in displays}
    for file, display, name in displays:
        topic = topic_of(display, "Description Topic")
        source = scalar(display, "Description Source")
        is_topic = source is None or source.text == "Topic"
        if topic is None or not name.endswith("/RobotModel") or not is_topic:
            continue
        read = _described(display)
        if read not in published:
            other = next(iter(published))
            is_shared = _is_shown_elsewhere(context, file.path, read)
            help = f"remap {read} to {other} for RViz" if is_shared else f"write {other}"
            if (file.path, other) in shown:  # the robot itself: this display is of another model
                help = f"remove the display, or start what publishes {read}"
            yield _finding(
                topic.span,
                f"RobotModel of RViz reads '{topic.text}', but nothing publishes a robot there",
                help,
                file,
            )


def _described(display: dict[str, Node]) -> str:
    """The full name of the topic of the robot that a display shows."""
    topic = topic_of(display, "Description Topic")
    return f"/{topic.text.strip('/')}" if topic else ""


def _is_shown_elsewhere(context: Context, path: str, topic: str) -> bool:
    """True if another launch file publishes the topic for the same RViz configuration."""
    for launch in workspace_launches(context):
        names = any(file.path == path for file in launch.files)
        for node in launch.programs if names else ():
            is_known = node.namespace is not None and not node.is_remapped and not launch.has_scopes
            published = resolve_name("robot_description", node.namespace)
            if node.package == "robot_state_publisher" and (published == topic or not is_known):
                return True
    return False


def meshes_without_uri(context: Context) -> Findings:
    """Meshes with paths in place of URIs, as of ``$(find)``, or with Gazebo's ``model://``."""
    if all(node.package not in ("rviz", "rviz2") for node in context.launch.started):
        return
    reported: set[str] = set()
    for description, robot in context.described_robots:
        for mesh in robot.files.meshes:
            path = mesh.located.path
            package = context.resolver.packages.enclosing(path) if path else None
            is_path = mesh.located.reference.startswith("/")
            is_lost = is_path or mesh.located.scheme in ("relative", "model")
            if path is None or package is None or not is_lost or description.path in reported:
                continue
            reported.add(description.path)
            relative = os.path.relpath(path, package[1]).replace(os.sep, "/")
            yield Finding(
                mesh.at,
                f"{mesh.who} is not found by RViz, which reads only package:// and file://",
                f"write package://{package[0]}/{relative}",
                related=(Related(description.frame.call.span, "the robot is started here"),),
            )


def _finding(at: Span, message: str, help: str, file: FileUse) -> Finding:
    note = Related(file.span, "the file is named here")
    return Finding(at, message, help, related=(note,))
