"""Velocity commands that a node publishes but nothing reads.

- Nothing reads their topic. Reported only if all programs of the workspace are known, and velocity
  commands are read on another topic.
- All that reads their topic expects ``TwistStamped`` instead of ``Twist``, or the reverse.

Sources: ``twist_mux.cpp`` of ros-teleop/twist_mux, ``teleop_twist_joy.cpp`` of
ros2/teleop_twist_joy, ``diff_drive_controller.cpp`` of ros2_controllers (all of humble to rolling).
"""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterable, Iterator

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.processes import is_silent_process
from urdfkit.checks.bringup.unread_remappings import renamed_topics
from urdfkit.checks.bringup.workspace_launches import (
    all_launches,
    is_included,
    programs_of,
    robots_of_workspace,
    workspace_launches,
)
from urdfkit.core.record import Record
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.catalog import data
from urdfkit.ros.gazebo.topics import are_all_known
from urdfkit.ros.launch.bridges import FROM_GAZEBO, bridged_topics
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import IncludedFile, Launch, StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter
from urdfkit.ros.launch.spawned_controllers import (
    MANAGER,
    resolve_name,
    spawned_controllers,
    topic_name,
)
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value, mapping, scalar
from urdfkit.text.source import Span
from urdfkit.workspace.program_strings import may_read
from urdfkit.workspace.ros_packages import comes_with_ros

#: Packages whose nodes read no velocity commands, except on topics in their parameters.
_OTHERS = re.compile(
    r"robot_state_publisher|joint_state_publisher(_gui)?|ros_gz_(sim|image|bridge)|rviz2|tf2_ros"
    r"|moveit_ros_move_group|slam_toolbox|robot_localization|controller_manager|twist_mux|joy"
    r"|teleop_twist_(joy|keyboard)|nav2_(?!velocity_smoother|collision_monitor)\w+"
)
_SMOOTHERS = ("nav2_velocity_smoother", "nav2_collision_monitor")
#: Launch files of Nav2, whose last node publishes the commands on ``cmd_vel``.
_NAVIGATION = re.compile(r".*/nav2_bringup/launch/(navigation|bringup)_launch\.py")
#: Topics of the smoothers: defaults, and those of Nav2's launch files.
_SMOOTHED = ("/cmd_vel", "/cmd_vel_nav", "/cmd_vel_smoothed", "/cmd_vel_raw")
DRIVE = re.compile(r"\w*(DiffDrive|Mecanum|OmniWheel|Tricycle|Steering)\w*Controller")
#: The parameter of a drive for stamped commands, and the suffix of the topic without stamps.
_STAMPED, _PLAIN = "use_stamped_vel", "_unstamped"
_OF_NAVIGATION = "/cmd_vel"
_SMOOTHER, _OF_SMOOTHER = "velocity_smoother", "cmd_vel_smoothed"
_MONITOR, _IN, _OUT = "collision_monitor", "cmd_vel_in_topic", "cmd_vel_out_topic"
_MUX, _MUX_STAMPED = "twist_mux", "use_stamped"
_COMMAND = re.compile(r"cmd_vel|reference")
_TWIST, _TWIST_STAMPED = "Twist", "TwistStamped"


class Reader(Record):
    """A topic on which velocity commands are read."""

    topic: str
    message: str  # Twist or TwistStamped
    at: Span
    is_mux: bool = False  # True for an input of twist_mux

    @property
    def related(self) -> Related:
        return Related(self.at, "the reader")


def unread_commands(context: Context) -> Findings:
    """Nodes whose velocity commands nothing reads, and outputs of Nav2."""
    sources = list(command_sources(context.launch.programs))
    navigation = [file for file in context.launch.includes if _NAVIGATION.fullmatch(file.path)]
    if not (sources or navigation) or is_included(context):
        return
    launches = all_launches(context)
    programs = programs_of(launches)
    if not all(map(_is_whole, launches)) or _may_have_other_readers(programs, context):
        return
    all_readers = list(command_readers(context, programs))
    readers = {reader.topic: reader.related for reader in all_readers}
    drives = {reader.topic: reader.related for reader in all_readers if not reader.is_mux}
    # Commands for the topic of a drive without stamps are mistyped: see mistyped_commands.
    read = {*readers, *(topic.removesuffix(_PLAIN) for topic in readers)}
    if drives:
        published = {topic for _, topic in sources}
        free = (one for one in all_readers if one.is_mux and one.topic not in published)
        inputs = {reader.topic: reader.related for reader in free} or drives
        yield from _unread_outputs(context, launches, inputs, read)
        yield from _unread_navigation(context, navigation, launches, drives, read)
    read |= _read_by_smoothers(launches, context)
    published = {topic for _, topic in sources} | _outputs(context)
    waiting = {topic: note for topic, note in readers.items() if topic not in published}
    for node, topic in sources if readers else ():
        is_alone = waiting or node.package not in _SMOOTHERS  # else a monitor waits for it
        if topic in read or _is_named(topic, launches, context) or not is_alone:
            continue
        if controller := _not_spawned(topic, programs, context):
            message = f"'{node.executable}' publishes '{topic}', which nothing reads: no launch "
            message += f"file spawns controller '{controller}'"
            yield Finding(node.at, message, f"spawn {controller}")
        elif known := drives if node.package == _MUX else waiting or readers:
            other, message = _unread(node.executable, topic, known)
            yield Finding(node.at, message, f"remap {topic} to {other}", related=(known[other],))


def _outputs(context: Context) -> set[str]:
    """The topics on which the collision monitors of parameter files publish."""
    paths = (file.path for file in context.launch.parameters)
    nodes = nodes_in_files(paths, context.resolver)
    written = (node.values.get(_OUT) for node in nodes)
    return {resolve_name(value.text, "") for value in written if isinstance(value, Value)}


def _not_spawned(topic: str, programs: list[StartedProgram], context: Context) -> str:
    """The drive whose commands are on a topic, and which no launch file spawns."""
    name, _, last = topic.strip("/").partition("/")
    if any(spawned.name == name for spawned in spawned_controllers(programs)):
        return ""
    controller = controllers_of_workspace(context).get(name) if _COMMAND.fullmatch(last) else None
    kind = controller.type.rpartition("/")[2] if controller else ""
    return name if controller and controller.ros == 2 and DRIVE.fullmatch(kind) else ""


def _may_have_other_readers(programs: list[StartedProgram], context: Context) -> bool:
    """True if a program, controller or plugin may read velocity commands on any topic."""
    defined = controllers_of_workspace(context)
    controllers = [defined.get(spawned.name) for spawned in spawned_controllers(programs)]
    return (
        not all(is_known_reader(node) or not _may_read(node, context) for node in programs)
        or not all(controller and controller.kind for controller in controllers)
        or not all(are_all_known(robot.model) for robot in robots_of_workspace(context))
    )


def _unread_outputs(
    context: Context, launches: Iterable[Launch], readers: dict[str, Related], read: set[str]
) -> Findings:
    """Outputs of the collision monitor of Nav2 that nothing reads."""
    smoothed = _inputs_of_smoothers(programs_of(launches), context)
    if smoothed is None:
        return
    paths = (file.path for file in context.launch.parameters)
    for node in nodes_in_files(paths, context.resolver):
        value = node.values.get(_OUT) if node.name == _MONITOR and not node.namespace else None
        if not isinstance(value, Value) or not re.fullmatch(r"[\w/]+", value.text):
            continue
        topic = resolve_name(value.text, "")
        if topic not in {*read, *smoothed} and not _is_named(topic, launches, context, 1):
            other, message = _unread(_MONITOR, topic, readers)
            help = f"write {other.strip('/')}"
            yield Finding(value.span, message, help, related=(readers[other],))


def _read_by_smoothers(launches: Iterable[Launch], context: Context) -> set[str]:
    """The topics on which the smoothers of Nav2 may read commands."""
    launches = list(launches)
    programs = programs_of(launches)
    smoothers = [node for node in programs if node.package in _SMOOTHERS]
    shipped = {file.span for launch in launches for file in launch.includes}
    if any(node.span in shipped for node in smoothers):
        return set(_SMOOTHED)  # what the launch files of Nav2 remap is not known
    read = (_inputs_of_smoothers(programs, context) or set(_SMOOTHED)) if smoothers else set()
    is_alone = all(node.executable == _SMOOTHER for node in smoothers)
    return read - {f"/{_OF_SMOOTHER}"} if is_alone else read


def _inputs_of_smoothers(programs: list[StartedProgram], context: Context) -> set[str] | None:
    """The topics on which the smoothers of Nav2 read commands; None if they are unknown."""
    smoothers = [node for node in programs if node.package in _SMOOTHERS]
    if not any(node.is_remapped for node in smoothers):
        return set(_SMOOTHED)
    topics = {_input_of_smoother(node, context) for node in smoothers}
    known = {topic for topic in topics if topic is not None}
    return known if len(known) == len(topics) else None


def _input_of_smoother(node: StartedProgram, context: Context) -> str | None:
    if node.executable == _SMOOTHER:
        return topic_name("cmd_vel", node)
    name = given_parameter(node, _IN, context.resolver) if node.executable == _MONITOR else None
    return None if name is None else topic_name(name or _OF_SMOOTHER, node)


def _unread_navigation(
    context: Context,
    navigation: Iterable[IncludedFile],
    launches: Iterable[Launch],
    readers: dict[str, Related],
    read: set[str],
) -> Findings:
    """Launch files of Nav2, if nothing reads their commands."""
    spans = {file.span for launch in launches for file in launch.includes}
    smoothers = (node for node in programs_of(launches) if node.package in _SMOOTHERS)
    if _OF_NAVIGATION in read or any(node.span not in spans for node in smoothers):
        return
    paths = (file.path for file in context.launch.parameters)
    outputs = [node.values.get(_OUT) for node in nodes_in_files(paths, context.resolver)]
    written = [value for value in outputs if isinstance(value, Value)]
    own = sum(resolve_name(value.text, "") == _OF_NAVIGATION for value in written)
    if own < len(written) or _is_named(_OF_NAVIGATION, launches, context, own):
        return
    for file in navigation:
        if file.is_sure and file.arguments is not None and "namespace" not in file.arguments:
            other, message = _unread(os.path.basename(file.path), _OF_NAVIGATION, readers)
            help = f"remap {other} to {_OF_NAVIGATION} for its reader, or start twist_mux"
            yield Finding(file.span, message, help, related=(readers[other],))


def _unread(publisher: str, topic: str, readers: Iterable[str]) -> tuple[str, str]:
    """The topic that is read in place of one that nothing reads, and the message."""
    other = nearest(topic, readers, 0) or next(iter(readers))
    return other, (
        f"'{publisher}' publishes '{topic}', which nothing reads; velocity commands are read on "
        f"'{other}'"
    )


def mistyped_commands(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Nodes whose velocity commands have another type than their readers expect."""
    yield from _mistyped(context, programs, trusted_readers(context, programs))


def trusted_readers(
    context: Context, programs: tuple[StartedProgram, ...]
) -> Callable[[Reader], bool]:
    """A filter of readers: if a twist_mux publishes the wrong type, it also reads the wrong one."""
    drives = _mistyped(context, programs, lambda reader: not reader.is_mux)
    muxes = {node.at for node in programs if node.package == _MUX}
    is_wrong = bool(muxes) and any(finding.at in muxes for finding in drives)
    return lambda reader: not (is_wrong and reader.is_mux)


def _mistyped(
    context: Context, programs: tuple[StartedProgram, ...], is_trusted: Callable[[Reader], bool]
) -> Findings:
    sources = list(command_sources(programs))
    own = list(filter(is_trusted, command_readers(context, programs))) if sources else []
    others: list[Reader] | None = None
    for node, topic in sources:
        switch, default = data("nodes")["stamped"].get(node.key, ("", ""))
        is_stamped = given_parameter(node, switch, context.resolver)
        if is_stamped is None or (is_stamped or default).lower() not in ("true", "false"):
            continue
        message = _TWIST_STAMPED if (is_stamped or default).lower() == "true" else _TWIST
        # Without stamps a drive has another topic until Humble, and later none.
        topics = (topic, f"{topic}{_PLAIN}")
        readers = [reader for reader in own if reader.topic in topics]
        if not readers:
            if others is None:
                every = command_readers(context, _programs_of_workspace(context))
                others = list(filter(is_trusted, every))
            readers = [reader for reader in others if reader.topic in topics]
        expected = [_TWIST_STAMPED if x.topic != topic else x.message for x in readers]
        if readers and message not in expected:
            reader, who = readers[0], f"'{node.executable}' publishes {message} on '{topic}'"
            set_parameter = f"set its parameter {switch}: {str(message == _TWIST).lower()}"
            yield Finding(
                node.at,
                f"{who}, where {expected[0]} is read",
                set_parameter if reader.topic == topic else f"remap {topic} to {reader.topic}",
                related=(reader.related,),
            )


def _programs_of_workspace(context: Context) -> list[StartedProgram]:
    """The programs of all launch files; empty if others than the known ones may read commands."""
    launches = workspace_launches(context)
    programs = programs_of(launches)
    are_known = all(map(_is_whole, launches)) and all(map(is_known_reader, programs))
    return programs if are_known else []


def command_sources(programs: Iterable[StartedProgram]) -> Iterator[tuple[StartedProgram, str]]:
    """The nodes that publish velocity commands, and the topics of these."""
    published: dict[str, str] = data("nodes")["commands"]
    for node in programs:
        name = published.get(node.key)
        if name and (topic := topic_name(name, node)):
            yield node, topic


def is_part_of_ros(path: str) -> bool:
    """True for an included file of ROS, which starts no robot."""
    return path.startswith(f"{UNKNOWN}/") and comes_with_ros(path.split("/")[2])


def _is_whole(launch: Launch) -> bool:
    return not launch.has_scopes and all(map(is_part_of_ros, launch.unread))


def is_known_reader(program: StartedProgram) -> bool:
    """True if the topics on which a program reads velocity commands are known."""
    if program.remappings is None or program.namespace is None:
        return False
    if program.package == MANAGER:  # its remappings and arguments apply to the controllers
        renamed = " ".join(
            (*program.remappings, *(word.text or "cmd_vel" for word in program.words))
        )
        return _COMMAND.search(renamed) is None
    if program.package in _SMOOTHERS or is_silent_process(program):
        return True
    return bool(_OTHERS.fullmatch(program.package))


def _may_read(program: StartedProgram, context: Context) -> bool:
    """False for a program of the workspace whose source names no velocity commands."""
    return may_read(program.package, _TWIST, context.source.path, context.resolver)


def command_readers(context: Context, programs: Iterable[StartedProgram]) -> Iterator[Reader]:
    """Topics on which the bridge and wheel controllers read velocity commands."""
    spawned_programs = list(spawned_controllers(programs))
    defined = controllers_of_workspace(context) if spawned_programs else {}
    renamed = renamed_topics(context) if spawned_programs else {}
    for node in programs:
        for topic in bridged_topics(node, context.resolver):
            message = topic.ros_type.rpartition("/")[2]
            name = topic_name(topic.ros_topic, node)
            is_twist = message in (_TWIST, _TWIST_STAMPED)
            if is_twist and topic.direction != FROM_GAZEBO and name:
                yield Reader(name, message, topic.span)
        yield from _read_by_mux(node, context)
    for spawned in spawned_programs:
        controller = defined.get(spawned.name)
        kind = controller.type.rpartition("/")[2] if controller and controller.ros == 2 else ""
        if controller and DRIVE.fullmatch(kind):
            name = "reference" if "Steering" in kind or "Mecanum" in kind else "cmd_vel"
            stamped = [value.text.lower() for value in controller.section.values(_STAMPED)]
            is_plain = "false" in stamped
            topic_of_drive = f"/{controller.name}/{name}{_PLAIN * is_plain}"
            topic_of_drive = renamed.get(topic_of_drive, topic_of_drive)
            at = spawned.word.span
            yield Reader(topic_of_drive, _TWIST if is_plain else _TWIST_STAMPED, at)


def _read_by_mux(node: StartedProgram, context: Context) -> Iterator[Reader]:
    """The inputs of twist_mux, if its parameters tell their type."""
    is_stamped = given_parameter(node, _MUX_STAMPED, context.resolver) or ""
    if node.package != _MUX or is_stamped.lower() not in ("true", "false"):
        return
    message = _TWIST_STAMPED if is_stamped.lower() == "true" else _TWIST
    for section in nodes_in_files(node.parameters.files, context.resolver):
        for entry in mapping(section.values.get("topics")).values():
            topic = scalar(entry, "topic")
            if topic:
                name = resolve_name(topic.text, node.namespace)
                yield Reader(name, message, topic.span, is_mux=True)


def _is_named(topic: str, launches: Iterable[Launch], context: Context, own: int = 0) -> bool:
    """True if a parameter file contains the topic, so that a node may read it.

    Args:
        own: how often the publisher itself contains it.
    """
    written = re.compile(rb"(?<![\w/])/?%b(?![\w/])" % re.escape(topic.strip("/").encode()))
    paths = {file.path for launch in launches for file in launch.parameters}
    sources = filter(None, map(context.resolver.readable, paths))
    return sum(len(written.findall(source.data)) for source in sources) > own
