"""Programs that look for one another under different names."""

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
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.document import Element
from urdfkit.text.source import Span

_PUBLISHER = "robot_state_publisher"
_DESCRIPTION = "robot_description"
#: Parameters of ros2_control_node that define no controller.
_OF_NODE = frozenset((_DESCRIPTION, "use_sim_time", "update_rate"))


def unpublished_description(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """What spawns or shows the robot waits on a topic that no robot_state_publisher has."""
    publishers = [one for one in started if one.package == _PUBLISHER]
    topics = [topic_name(_DESCRIPTION, one) for one in publishers]
    published = {topic: one for topic, one in zip(topics, publishers, strict=True) if topic}
    if not published or None in topics:
        return
    yield from unpublished_models(context, {name: one.span for name, one in published.items()})
    for one in started:
        spawner = spawner_of(one)
        topic = options(one, spawner)[0].get("topic") if spawner else None
        name = topic_name(topic.text, one) if topic and topic.text else None
        if topic and name and name not in published:
            known = next(iter(published))
            yield Finding(
                Location(topic.span, one.frame),
                f"nothing publishes '{name}'; {_PUBLISHER} publishes '{known}'",
                f"write {known}",
                related=(Related(published[known].span, f"{_PUBLISHER} is started here"),),
            )


def other_manager(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Spawners that wait for a controller manager in another namespace than that which runs."""
    if any(_renames(one) for one in started):
        return
    running = list(_managers(context, started))
    if not running or any(name is None for name, _ in running):
        return
    known = {name: place for name, place in running if name}
    for one in started:
        name = manager_name(one)
        if name and name not in known and any(True for _ in controllers(one)):
            wanted = manager(one)
            other, place = next(iter(known.items()))
            yield Finding(
                Location(wanted.span if wanted else one.span, one.frame),
                f"the spawner waits for '{name}', which nothing starts; the controller manager is "
                f"'{other}'",
                f"write --controller-manager {other}"
                if one.is_ros_2
                else f'write ns="{other.rpartition("/")[0] or "/"}"',
                related=(Related(place, "it is started here"),),
            )


def without_types(started: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager without parameters, by which a spawner knows no type of a controller."""
    spawners = [one for one in started if any(True for _ in controllers(one))]
    words = {word.text for one in spawners for word in one.words}
    if not spawners or not words.isdisjoint((None, "-p", "--param-file")):
        return
    for one in started:
        every = one.parameters.every
        is_manager = (one.package, one.executable) == (MANAGER, "ros2_control_node")
        if is_manager and every is not None and _OF_NODE.issuperset(every):
            yield Finding(
                Location(one.span, one.frame),
                "ros2_control_node has no parameter file, so no controller has a type",
                "pass the YAML file of the controllers to it",
                related=(Related(spawners[0].span, "a spawner"),),
            )


def _renames(started: StartedProgram) -> bool:
    """True for a program that spawns a robot in a namespace of its choice."""
    spawner = spawner_of(started)
    return spawner is not None and "robot_namespace" in options(started, spawner)[0]


def _managers(
    context: Context, started: tuple[StartedProgram, ...]
) -> Iterator[tuple[str | None, Span]]:
    """The controller managers that are started; None for a name that is not known."""
    for one in started:
        if one.package == MANAGER and one.executable == "ros2_control_node":
            is_plain = one.namespace is not None and one.name in ("", MANAGER)
            yield resolve_name(MANAGER, one.namespace) if is_plain else None, one.span
    if not any(map(spawner_of, started)):
        return
    for description, robot in context.described_robots:
        for plugin in control_plugins(robot.model):
            is_ros1 = plugin.kind == "gazebo_ros_control"
            if is_ros1 or "ros2_control" in plugin.filename:
                named = _of_ros1(plugin.at) if is_ros1 else _of_plugin(plugin.at)
                yield named if description.is_whole else None, plugin.at.span


def _of_ros1(plugin: Element) -> str | None:
    """The controller manager of gazebo_ros_control; without a namespace in that of the model."""
    namespace = plugin.child("robotNamespace")
    return None if namespace is None else resolve_name(MANAGER, namespace.text.strip().strip("/"))


def _of_plugin(plugin: Element) -> str | None:
    """The controller manager of a plugin of Gazebo."""
    ros = plugin.child("ros")
    namespace = ros.child("namespace") if ros else None
    named = plugin.child("controller_manager_name") or plugin.child("controller_manager_node_name")
    if named is None and plugin.child("controller_manager_prefix_node_name") is not None:
        return None
    name = named.text.strip() if named is not None else MANAGER
    return resolve_name(name, namespace.text.strip().strip("/") if namespace is not None else "")
