"""Velocity commands of Nav2: with or without stamps, and from one node to the next.

Sources: ``twist_publisher.hpp`` of nav2_util (enable_stamped_cmd_vel is false up to Jazzy),
``navigation_launch.py`` of nav2_bringup and ``collision_monitor_node.cpp``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from urdfkit.checks.bringup.unread_commands import (
    command_readers,
    command_sources,
    is_known_reader,
    trusted_readers,
)
from urdfkit.checks.bringup.workspace_launches import programs_of, workspace_launches
from urdfkit.core.record import Record
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Context, Finding, Findings, Related
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.spawned_controllers import resolve_name, topic_name
from urdfkit.ros.node_parameters import NodeParameters, nodes_in_files
from urdfkit.text.located_yaml import Value, scalar
from urdfkit.text.source import Span
from urdfkit.workspace.program_strings import may_publish
from urdfkit.workspace.resolve import Resolver

_STAMPED = "enable_stamped_cmd_vel"
_SMOOTHER, _MONITOR = "velocity_smoother", "collision_monitor"
#: The nodes of Nav2 that publish or read velocity commands.
_COMMANDING = ("controller_server", "behavior_server", _SMOOTHER, _MONITOR)
_IN, _OUT = "cmd_vel_in_topic", "cmd_vel_out_topic"
#: Topics of the controller and of its behaviours, alone and in Nav2's launch files.
_OF_CONTROLLER = ("/cmd_vel", "/cmd_vel_nav")


class _Output(Record):
    """The last node of Nav2 before the robot."""

    section: NodeParameters
    topic: str


def mixed_stamps(sections: list[NodeParameters]) -> Findings:
    """Nodes of Nav2 with and without stamps, which do not understand one another."""
    nodes = [section for section in sections if section.name in _COMMANDING]
    given = [(node, _text(node, _STAMPED).lower()) for node in nodes]
    stamped = [node for node, text in given if text == "true"]
    plain = [node for node, text in given if text == "false"]
    if not stamped or any("*" in section.name for section in sections):
        return
    fewer, text = (plain, "true") if len(plain) <= len(stamped) else (stamped, "false")
    other = (stamped if fewer is plain else plain)[0].name
    for node in fewer:
        value = node.values[_STAMPED]
        if isinstance(value, Value):
            message = f"'{node.name}': {_STAMPED} is {value.text}, unlike that of '{other}'"
            help = f"write {_STAMPED}: {text}"
            yield Finding(value.span, message, help)
    for node, text in given if not plain else ():
        if not text and _STAMPED not in node.values:
            message = f"'{node.name}' lacks {_STAMPED}: true, which '{other}' has; it is false "
            help = f"add {_STAMPED}: true"
            message += "by default up to Jazzy"
            yield Finding(node.at, message, help)


def _text(node: NodeParameters, key: str, default: str = "") -> str:
    value = scalar(node.values, key)
    return value.text if value else default


def mistyped_navigation(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Commands of Nav2 without stamps for a drive that reads them with stamps."""
    is_trusted = trusted_readers(context, started)
    readers = filter(is_trusted, command_readers(context, started))
    expected = {reader.topic: reader for reader in readers}
    launches = workspace_launches(context) if expected else ()
    places: set[Span] = set()
    for output in (output for launch in launches for output in _outputs(launch, context.resolver)):
        reader, section = expected.get(output.topic), output.section
        switch = scalar(section.values, _STAMPED)
        is_stamped = _text(section, _STAMPED, "false").lower()
        if reader is None or is_stamped not in ("true", "false"):
            continue
        message = "TwistStamped" if is_stamped == "true" else "Twist"
        at = switch.span if switch else section.at
        if message != reader.message and at not in places:
            places.add(at)
            until = "" if switch else " up to Jazzy"
            yield Finding(
                at,
                f"'{section.name}'{until} publishes {message} on '{output.topic}', where "
                f"{reader.message} is read",
                f"write {_STAMPED}: {str(reader.message == 'TwistStamped').lower()}, in all nodes "
                "of Nav2",
                related=(reader.related,),
            )


def _outputs(launch: Launch, resolver: Resolver) -> Iterator[_Output]:
    """The last node of Nav2 in a launch file, by its parameter files."""
    if launch.has_scopes or any(node.namespace != "" for node in launch.programs):
        return
    smoothers = [node for node in launch.programs if node.executable == _SMOOTHER]
    monitors = [node for node in launch.programs if node.executable == _MONITOR]
    for section in _sections(launch, resolver):
        is_started = bool(smoothers and not smoothers[0].is_remapped) or bool(monitors)
        if section.name == _MONITOR and is_started:
            yield _Output(section, resolve_name(_text(section, _OUT, "cmd_vel"), ""))


def _sections(launch: Launch, resolver: Resolver) -> Iterator[NodeParameters]:
    return nodes_in_files((file.path for file in launch.parameters if file.exists), resolver)


def unpublished_commands(context: Context) -> Findings:
    """A collision monitor that reads commands on a topic on which nothing publishes them."""
    smoothers = [node for node in context.launch.programs if node.executable == _SMOOTHER]
    if not smoothers:
        return
    launches = workspace_launches(context)
    programs = programs_of(launches)
    if any(launch.has_scopes for launch in launches) or not all(
        is_known_reader(node)
        or not may_publish(node.package, "Twist", context.source.path, context.resolver)
        for node in programs
    ):
        return
    published = [topic for topic in _published(smoothers, programs) if topic]
    for section in _sections(context.launch, context.resolver):
        value = scalar(section.values, _IN)
        name = resolve_name(value.text, "") if value else ""
        if section.name == _MONITOR and value and name not in published:
            other = nearest(name, published[:1], 0) or published[0]
            yield Finding(
                value.span,
                f"'{_MONITOR}' waits for '{name}', which nothing publishes; '{_SMOOTHER}' "
                f"publishes '{other}'",
                f"write {other.strip('/')}",
                related=(Related(smoothers[0].span, f"'{_SMOOTHER}' is started here"),),
            )


def _published(
    smoothers: list[StartedProgram], programs: Iterable[StartedProgram]
) -> Iterator[str | None]:
    for node in smoothers:
        yield topic_name("cmd_vel_smoothed", node)
    yield from _OF_CONTROLLER
    yield from (topic for _, topic in command_sources(programs))
