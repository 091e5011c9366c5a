"""Programs that expect a topic or a controller manager under another name than it has."""

from collections.abc import Iterator

from urdfkit.checks.launch.rviz_displays import unpublished_models
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import (
    MANAGER,
    controllers,
    manager,
    manager_name,
    resolve_name,
    topic_name,
)
from urdfkit.ros.launch.spawning import options, spawner_of
from urdfkit.ros.ros_control import control_plugins, namespace_of
from urdfkit.text.document import Element
from urdfkit.text.source import Span

_PUBLISHER = "robot_state_publisher"
_DESCRIPTION = "robot_description"
#: Parameters of ros2_control_node other than those of controllers.
_OF_NODE = frozenset((_DESCRIPTION, "use_sim_time", "update_rate"))


def unpublished_description(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Spawners and displays that read the robot from a topic that nothing publishes."""
    publishers = [node for node in started if node.package == _PUBLISHER]
    topics = [topic_name(_DESCRIPTION, node) for node in publishers]
    published = {topic: node for topic, node in zip(topics, publishers, strict=True) if topic}
    if not published or None in topics:
        return
    yield from unpublished_models(context, {name: node.span for name, node in published.items()})
    for node in started:
        spawner = spawner_of(node)
        topic = options(node, spawner)[0].get("topic") if spawner else None
        name = topic_name(topic.text, node) if topic and topic.text else None
        if topic and name and name not in published:
            known = next(iter(published))
            yield Finding(
                Location(topic.span, node.frame),
                f"nothing publishes '{name}'; {_PUBLISHER} publishes '{known}'",
                f"write {known}",
                related=(Related(published[known].span, f"{_PUBLISHER} is started here"),),
            )


def manager_in_another_namespace(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Spawners that wait for a controller manager in the wrong namespace."""
    if any(_renames(node) for node in started):
        return
    running = list(_managers(context, started))
    if not running or any(name is None for name, _ in running):
        return
    known = {name: place for name, place in running if name}
    for node in started:
        name = manager_name(node)
        if name and name not in known and any(True for _ in controllers(node)):
            written = manager(node)
            other, place = next(iter(known.items()))
            yield Finding(
                Location(written.span if written else node.span, node.frame),
                f"the spawner waits for '{name}', which nothing starts; the controller manager is "
                f"'{other}'",
                f"write --controller-manager {other}"
                if node.is_ros_2
                else f'write ns="{other.rpartition("/")[0] or "/"}"',
                related=(Related(place, "the controller manager is started here"),),
            )


def untyped_controllers(started: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager without parameters, and so without types of controllers."""
    spawners = [node for node in started if any(True for _ in controllers(node))]
    words = {word.text for node in spawners for word in node.words}
    if not spawners or not words.isdisjoint((None, "-p", "--param-file")):
        return
    for node in started:
        parameters = node.parameters.every
        is_manager = (node.package, node.executable) == (MANAGER, "ros2_control_node")
        if is_manager and parameters is not None and _OF_NODE.issuperset(parameters):
            yield Finding(
                Location(node.span, node.frame),
                "ros2_control_node has no parameter file, so no controller has a type",
                "pass the YAML file of the controllers to it",
                related=(Related(spawners[0].span, "a spawner"),),
            )


def _renames(started: StartedProgram) -> bool:
    """True for a program that spawns a robot with ``-robot_namespace``."""
    spawner = spawner_of(started)
    return spawner is not None and "robot_namespace" in options(started, spawner)[0]


def _managers(
    context: Context, started: tuple[StartedProgram, ...]
) -> Iterator[tuple[str | None, Span]]:
    """The controller managers that are started; None for an unknown name."""
    for node in started:
        if node.package == MANAGER and node.executable == "ros2_control_node":
            is_plain = node.namespace is not None and node.name in ("", MANAGER)
            yield resolve_name(MANAGER, node.namespace) if is_plain else None, node.span
    if not any(map(spawner_of, started)):
        return
    for description, robot in context.described_robots:
        for plugin in control_plugins(robot.model):
            is_ros1 = plugin.kind == "gazebo_ros_control"
            if is_ros1 or "ros2_control" in plugin.filename:
                name = _ros1_manager(plugin.at) if is_ros1 else _plugin_manager(plugin.at)
                yield name if description.is_whole else None, plugin.at.span


def _ros1_manager(plugin: Element) -> str | None:
    """The controller manager of gazebo_ros_control; None in the namespace of the model."""
    namespace = plugin.child("robotNamespace")
    return None if namespace is None else resolve_name(MANAGER, namespace.text.strip().strip("/"))


def _plugin_manager(plugin: Element) -> str | None:
    """The controller manager of a plugin of Gazebo; None if the plugin adds a prefix."""
    namespace = namespace_of(plugin)
    named = plugin.child("controller_manager_name") or plugin.child("controller_manager_node_name")
    if named is None and plugin.child("controller_manager_prefix_node_name") is not None:
        return None
    name = named.text.strip() if named is not None else MANAGER
    return resolve_name(name, namespace.text.strip().strip("/") if namespace is not None else "")
