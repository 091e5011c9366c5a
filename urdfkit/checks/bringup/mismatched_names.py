"""Programs that wait for a topic or a controller manager that is missing or has another name."""

from collections.abc import Iterator

from urdfkit.checks.bringup.rviz_displays import unpublished_models
from urdfkit.checks.bringup.workspace_launches import programs_of, workspace_launches
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.catalog.ros_control import simulated_hardware
from urdfkit.ros.launch.argument_checks import is_included
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.launch.spawned_controllers import (
    MANAGER,
    manager,
    manager_name,
    resolve_name,
    spawns_controllers,
    topic_name,
)
from urdfkit.ros.launch.spawning import model_spawner, spawn_option
from urdfkit.ros.ros_control import components, control_plugins, namespace_of
from urdfkit.text.document import Element
from urdfkit.text.source import Span
from urdfkit.workspace.launch_files import launch_files
from urdfkit.workspace.program_strings import may_contain
from urdfkit.workspace.ros_packages import comes_with_ros

_PUBLISHER = "robot_state_publisher"
_DESCRIPTION = "robot_description"
_CONTROL_NODE = f"{MANAGER}/ros2_control_node"
#: Words in a program that starts a controller manager.
_STARTS_MANAGER = ("ControllerManager", "ros2_control_node")
#: What launch files contain that start it, also by functions of MoveIt.
_PUBLISHING = (_PUBLISHER, "generate_rsp_launch", "generate_demo_launch")
#: A parameter of MoveIt, which may publish the robot, too.
_PUBLISHES = b"publish_robot_description"
#: Parameters of ros2_control_node other than those of controllers.
_OF_NODE = frozenset((_DESCRIPTION, "use_sim_time", "update_rate"))


def unpublished_description(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Spawners and displays that read the robot from a topic that nothing publishes."""
    publishers = [node for node in programs if node.package == _PUBLISHER]
    if not publishers and not context.launch.descriptions:
        publishers = _publishers_elsewhere(context)
    topics = [topic_name(_DESCRIPTION, node) for node in publishers]
    published = {topic: node for topic, node in zip(topics, publishers, strict=True) if topic}
    if not published or None in topics:
        return
    yield from unpublished_models(context, {name: node.span for name, node in published.items()})
    for node in programs:
        topic = spawn_option(node, "topic")
        name = topic_name(topic.text, node) if topic and topic.text else None
        if topic and name and name not in published:
            known = next(iter(published))
            yield Finding(
                Location(topic.span, node.frame),
                f"nothing publishes '{name}'; {_PUBLISHER} publishes '{known}'",
                f"write {known}",
                related=(Related(published[known].span, f"{_PUBLISHER} is started here"),),
            )


def _publishers_elsewhere(context: Context) -> list[StartedProgram]:
    """The publishers of the other launch files, next to which a file for navigation runs."""
    launches = workspace_launches(context)
    if any(launch.has_scopes for launch in launches):
        return []
    return [node for node in programs_of(launches) if node.package == _PUBLISHER]


def manager_in_another_namespace(
    context: Context, programs: tuple[StartedProgram, ...]
) -> Findings:
    """Spawners that wait for a controller manager in the wrong namespace."""
    if any(spawn_option(node, "robot_namespace") for node in programs):
        return
    running = list(_managers(context, programs))
    if not running or any(name is None for name, _ in running):
        return
    known = {name: place for name, place in running if name}
    for node in programs:
        name = manager_name(node)
        if name and name not in known and node.is_sure and spawns_controllers(node):
            written = manager(node)
            other, place = next(iter(known.items()))
            yield Finding(
                Location(written.span if written else node.span, node.frame),
                f"the spawner waits for '{name}', which nothing starts; the controller manager is "
                f"'{other}'",
                f"write --controller-manager {other}"
                + (", or remove the name of ros2_control_node" if _is_named(other) else "")
                if node.is_ros_2
                else f'write ns="{other.rpartition("/")[0] or "/"}"',
                related=(Related(place, "the controller manager is started here"),),
            )


def missing_manager(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A robot in Gazebo whose controllers are spawned, though it has no control plugin."""
    spawner = next((node for node in programs if node.is_sure and spawns_controllers(node)), None)
    models = [node for node in programs if model_spawner(node)]
    if spawner is None or len(models) != 1 or spawn_option(models[0], "file"):
        return
    packages = {node.package for node in programs if not comes_with_ros(node.package)}
    if any(_may_manage(package, context) for package in packages):
        return
    if any(True for _ in _managers(context, programs)):
        return
    for description, robot in context.described_robots:
        hardware = [component.hardware for component in components(robot.model)]
        may_be_loaded = any(
            use.plugin is None or "control" in use.filename for use in robot.plugins
        )
        # Hardware of Gazebo without its plugin is reported in the description.
        if (
            description.is_whole
            and not may_be_loaded
            and simulated_hardware().keys().isdisjoint(hardware)
        ):
            yield Finding(
                Location(description.frame.call.span, description.frame.outer),
                "the spawners wait for a controller manager, which nothing starts: this robot has "
                "no control plugin of Gazebo",
                "pass the arguments of xacro with which it has the plugin, or add the plugin to it",
                related=(Related(spawner.span, "a spawner"),),
            )


def _may_manage(package: str, context: Context) -> bool:
    """True if programs of a package may start a controller manager."""
    near, resolver = context.source.path, context.resolver
    return any(may_contain(package, word, near, resolver) for word in _STARTS_MANAGER)


def _is_named(manager: str) -> bool:
    """True for a controller manager with a name of its own."""
    return not manager.endswith(f"/{MANAGER}")


def unread_description(programs: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager that reads the robot from a topic that nothing publishes."""
    publishers = [node for node in programs if node.package == _PUBLISHER]
    topics = [topic_name(_DESCRIPTION, node) for node in publishers]
    for node in programs:
        is_manager = node.key == _CONTROL_NODE
        given = node.parameters.every if is_manager else None
        for old, new in (node.remappings or {}).items() if is_manager else ():
            name = resolve_name(new, node.namespace)
            is_read = old.rpartition("/")[2] == _DESCRIPTION and node.namespace is not None
            is_given = given is not None and _DESCRIPTION in given
            if is_read and not is_given and topics and None not in topics and name not in topics:
                yield Finding(
                    node.at,
                    f"the controller manager reads the robot from '{name}', which nothing "
                    f"publishes; {_PUBLISHER} publishes '{topics[0]}'",
                    f"remap {old} to {topics[0]}",
                    related=(Related(publishers[0].span, f"{_PUBLISHER} is started here"),),
                )


def missing_description(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager that gets the robot as a parameter only, which Jazzy does not read."""
    path, resolver = context.source.path, context.resolver
    managers = [node for node in programs if node.executable == "ros2_control_node"]
    others = [node for node in programs if node not in managers]
    is_known = all(
        comes_with_ros(node.package) and _PUBLISHES not in node.span.source.data for node in others
    )
    if not managers or not is_known or context.launch.unread or is_included(path, resolver):
        return
    workspace = resolver.packages.workspace(path)
    if any(any(launch_files(workspace, word, resolver)) for word in _PUBLISHING):
        return
    for node in managers:
        if _DESCRIPTION in node.parameters.values and is_for_jazzy(path, resolver):
            yield Finding(
                node.at,
                f"the controller manager waits for /{_DESCRIPTION}, which nothing publishes: since "
                "Jazzy it is no parameter of it",
                f"start {_PUBLISHER} with it",
            )


def untyped_controllers(programs: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager without parameters, and so without types of controllers."""
    spawners = [node for node in programs if node.is_sure and spawns_controllers(node)]
    words = {word.text for node in spawners for word in node.words}
    if not spawners or not words.isdisjoint((None, "-p", "--param-file")):
        return
    for node in programs:
        parameters = node.parameters.every
        is_manager = node.key == _CONTROL_NODE
        if is_manager and parameters is not None and _OF_NODE.issuperset(parameters):
            yield Finding(
                node.at,
                "ros2_control_node has no parameter file, so no controller has a type",
                "pass the YAML file of the controllers to it",
                related=(Related(spawners[0].span, "a spawner"),),
            )


def _managers(
    context: Context, programs: tuple[StartedProgram, ...]
) -> Iterator[tuple[str | None, Span]]:
    """The controller managers that are started; None for an unknown name."""
    for node in programs:
        if node.key == _CONTROL_NODE:
            is_known = node.namespace is not None and "$" not in node.name
            own_name = node.name or MANAGER
            yield resolve_name(own_name, node.namespace) if is_known else None, node.span
    if not any(map(model_spawner, programs)):
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
