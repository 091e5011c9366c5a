"""Nodes and hardware that do not match the simulation: clock, pause, ros2_control, joint states."""

import re

from urdfkit.checks.bringup.workspace_launches import is_included
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related, Severity
from urdfkit.robot.model import RobotModel
from urdfkit.ros.catalog import data
from urdfkit.ros.catalog.ros_control import simulated_hardware
from urdfkit.ros.launch.bridges import bridged_topics, is_bridge
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.ros.ros_control import Component, components, control_plugins
from urdfkit.text.comments import blank_comments
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.resolve import Resolver

_CLOCK = "clock"
_SLIDERS = "joint_state_publisher"
_SIM_TIME = "use_sim_time"
_PUBLISHER = "robot_state_publisher"
_MANAGER = "ros2_control_node"
#: Launch files of ROS that start Gazebo and no bridge.
_GAZEBO = ("gz_sim.launch.py", "gz_server.launch.py", "gzserver.launch.py", "ign_gazebo.launch.py")
#: Hardware that only Gazebo's plugin loads.
_OF_GAZEBO = ("gazebo_ros2_control/", "gz_ros2_control/", "ign_ros2_control/")
_MOCK = ("mock_components/GenericSystem", "fake_components/GenericSystem")
#: Names of hardware that may be that of a simulator.
_SIMULATED = re.compile(r"(?i)gazebo|gz|ign|sim|mujoco|webots|isaac|mock|fake|topic_based")
#: Packages whose programs publish no joint states, and no transforms of the links of joints.
_STATELESS = re.compile(
    r"robot_state_publisher|ros_gz_(sim|bridge|image)|rviz2|tf2_ros|robot_localization"
    r"|slam_toolbox|joy|twist_mux|teleop_twist_(joy|keyboard)|nav2_\w+"
)
#: Systems of gz-sim: one publishes joint states, the other the poses of links.
_STATES, _POSES = "joint-state-publisher", "pose-publisher"
_MAX_NAMED = 2


def missing_clock(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Nodes that use the time of a gz-sim whose clock is not bridged."""
    waiting = next((node for node in programs if _sim_time(node, context.resolver) is True), None)
    starts_gz = any(world.generation == GZ for world in worlds(context.launch))
    unread = (path.rpartition("/")[2] for path in context.launch.unread)
    if waiting is None or not starts_gz or not all(file in _GAZEBO for file in unread):
        return
    bridges = _bridges_of_gz(programs)
    if bridges is None or _bridges_clock(bridges, context.resolver):
        return
    yield Finding(
        (bridges[0] if bridges else waiting).at,
        f"'{waiting.executable}' waits with {_SIM_TIME} for /clock, which nothing publishes",
        "bridge /clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
    )


def stopped_controllers(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager of a robot, or of mock hardware, with the time of a simulation."""
    names = [f"{node.package}/{node.executable}" for node in programs]
    is_simulated = any(name == "/" or _SIMULATED.search(name) for name in names)
    if is_simulated or any(map(model_spawner, programs)) or context.launch.unread:
        return
    robots = [robot.model for _, robot in context.described_robots]
    hardware = [component for model in robots for component in components(model)]
    is_real = all(one.hardware in _MOCK or not _may_be_simulated(one) for one in hardware)
    if not hardware or not is_real or is_included(context):
        return
    for node in programs:
        if node.executable != _MANAGER or _SIM_TIME in node.parameters.values:
            continue
        for path in node.parameters.files:
            source = context.resolver.readable(path)
            for section in node_parameters(source) if source else ():
                value = section.values.get(_SIM_TIME)
                is_own = section.path in ((node.name or "controller_manager",), ("**",))
                if is_own and isinstance(value, Value) and value.text.lower() == "true":
                    yield Finding(
                        Location(value.span, node.frame),
                        f"controllers wait with {_SIM_TIME} for /clock, which nothing publishes",
                        f"write {_SIM_TIME}: false; Gazebo's plugin sets it itself",
                        related=(Related(node.span, "the controller manager"),),
                    )


def _bridges_of_gz(programs: tuple[StartedProgram, ...]) -> list[StartedProgram] | None:
    """The bridges of a gz-sim with a robot; None without it, or if their topics are unknown."""
    is_spawned = any(node.package == "ros_gz_sim" and model_spawner(node) for node in programs)
    bridges = [node for node in programs if is_bridge(node)]
    return bridges if is_spawned and all(map(_is_known, bridges)) else None


def _bridges_clock(bridges: list[StartedProgram], resolver: Resolver) -> bool:
    topics = [topic for node in bridges for topic in bridged_topics(node, resolver)]
    has_clock = any(topic.ros_type.endswith("/Clock") for topic in topics)
    is_remapped = has_clock and any(node.is_remapped for node in bridges)
    return is_remapped or any(topic.ros_topic.strip("/") == _CLOCK for topic in topics)


def wall_clock_nodes(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Nodes without simulation time, while other nodes use it."""
    if context.launch.has_scopes:
        return
    resolver, is_simulated = context.resolver, any(map(model_spawner, programs))
    other = next((node for node in programs if _sim_time(node, resolver) is True), None)
    for node in programs:
        severity = data("nodes")["stamping"].get(node.package)
        own = _sim_time(node, resolver) if severity else None
        is_slider = node.package.startswith(_SLIDERS) and not is_simulated
        if own is None or own is True or is_slider:
            continue
        if is_simulated and own is False and (other is not None or node.package == _PUBLISHER):
            message = f"{_SIM_TIME} of {node.executable} is false, but Gazebo is started"
        elif other is not None and own is False and severity == Severity.WARNING.value:
            message = f"{_SIM_TIME} of {node.executable} is false, unlike that of "
            message += f"'{other.executable}'"
        elif other is not None and (is_simulated or severity == Severity.WARNING.value):
            message = f"{node.executable} lacks {_SIM_TIME}, which '{other.executable}' sets"
        else:
            continue
        help = f'give it {{"{_SIM_TIME}": True}}'
        yield Finding(node.at, message, help, severity=Severity(severity))


def paused(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A gz sim that starts paused."""
    if not any(map(model_spawner, programs)):
        return
    waiting = any(controller.is_activated for controller in spawned_controllers(programs))
    for world in worlds(context.launch):
        if world.is_paused and world.is_sure:
            effect = "no controller becomes active" if waiting else "nothing moves"
            yield Finding(
                world.at,
                f"Gazebo starts paused: {effect} until Play is pressed",
                "write -r before the world",
                severity=None if waiting else Severity.INFO,
            )


def unloaded_hardware(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Hardware of a robot in Gazebo that Gazebo's control plugin does not load.

    It is mock hardware, or the files of the robot also name that of Gazebo, for other arguments.
    A launch file may describe its robot again, for MoveIt alone.
    """
    if not any(map(model_spawner, programs)):
        return
    robots = list(context.described_robots)
    simulated = {
        description.path
        for description, robot in robots
        if any(component.hardware.startswith(_OF_GAZEBO) for component in components(robot.model))
    }
    for description, robot in robots:
        if not description.is_whole or description.path in simulated:
            continue
        plugins = control_plugins(robot.model)
        hardware = components(robot.model)
        is_mock = hardware and all(component.hardware in _MOCK for component in hardware)
        is_real = not any(map(_may_be_simulated, hardware)) and _names_simulator(robot)
        for component in hardware if plugins and (is_mock or is_real) else ():
            yield Finding(
                Location((component.plugin or component.at).span, description.frame),
                f"{component.called}: {plugins[0].filename} does not load {component.hardware}, "
                "so the simulated robot does not move",
                "use the hardware of the simulator in a launch file with Gazebo",
                related=(Related(plugins[0].at.span, "control plugin"),),
            )


def _may_be_simulated(component: Component) -> bool:
    """True for the hardware of a simulator, by its name."""
    return not component.hardware or _SIMULATED.search(component.hardware) is not None


def _names_simulator(robot: Context) -> bool:
    """True if a file of the robot contains the name of Gazebo's hardware, outside of comments."""
    sources = robot.reading.xacro.sources if robot.reading.xacro else ()
    names = [f">{name}<".encode() for name in simulated_hardware()]
    texts = (blank_comments(source.data) for source in sources)
    return any(name in text for text in texts for name in names)


def hardware_without_simulator(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Hardware of Gazebo in ros2_control_node, without Gazebo."""
    managers = [node for node in programs if node.executable == _MANAGER]
    if not managers or any(map(model_spawner, programs)):
        return
    for description in context.launch.descriptions:
        robot = context.other_robot(description.path, description.arguments)
        if not description.is_whole or robot.reading.document is None:
            continue
        for component in components(robot.model):
            if component.hardware.startswith(_OF_GAZEBO):
                yield Finding(
                    Location((component.plugin or component.at).span, description.frame),
                    f"{component.called}: ros2_control_node does not load "
                    f"{component.hardware}, only Gazebo's plugin does",
                    "use the hardware of the robot, or mock_components/GenericSystem, in a launch "
                    "file without a simulator",
                    related=(Related(managers[0].span, "the controller manager"),),
                )


def unpublished_joint_states(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A robot of gz-sim in RViz whose joints have no states, so that links have no transform."""
    publisher = next((node for node in programs if node.package == _PUBLISHER), None)
    packages = {node.package for node in programs}
    bridges = _bridges_of_gz(programs)
    if publisher is None or "rviz2" not in packages or not bridges:
        return
    bridged = (topic for node in bridges for topic in bridged_topics(node, context.resolver))
    has_states = any(topic.ros_type.endswith("/JointState") for topic in bridged)
    if has_states or not all(map(_STATELESS.fullmatch, packages)):
        return
    if is_included(context):
        return
    for description, robot in context.described_robots:
        systems = _systems(robot.model)
        joints = [joint.name for joint in robot.model.joints if joint.degrees_of_freedom == 1]
        is_posed = any(_POSES in system for system in systems) or control_plugins(robot.model)
        if joints and not is_posed and description.is_whole:
            help = "bridge its topic as sensor_msgs/msg/JointState to /joint_states"
            if not any(_STATES in system for system in systems):
                help = f"add gz-sim-{_STATES}-system to the robot, and {help}"
            yield Finding(
                publisher.at,
                f"nothing publishes the states of {few(joints, _MAX_NAMED)}: RViz has no "
                "transform of their links",
                help,
            )


def _systems(model: RobotModel) -> list[str]:
    plugins = (plugin for block in model.gazebo for plugin in block.all("plugin"))
    return [plugin.get("filename") or "" for plugin in plugins]


def _is_known(bridge: StartedProgram) -> bool:
    """True if all topics of a bridge are known."""
    has_file = bridge.parameters.values.get("config_file", "") is not None
    is_whole = bridge.parameters.every is not None
    return has_file and is_whole and all(word.text is not None for word in bridge.words)


def _sim_time(node: StartedProgram, resolver: Resolver) -> bool | str | None:
    """Whether a node uses simulation time.

    Returns:
        None if that is unknown; an empty string if the parameter is not set, which means no.
    """
    value = node.parameters.values.get(_SIM_TIME, "")
    if _SIM_TIME in node.parameters.values:
        return {"true": True, "false": False}.get((value or "").lower())
    is_argument = any(_SIM_TIME in (word.text or _SIM_TIME) for word in node.words)
    is_whole = node.parameters.is_whole or node.parameters.is_of_moveit
    if is_argument or not is_whole:
        return None
    return _sim_time_in_files(node, resolver)


def _sim_time_in_files(node: StartedProgram, resolver: Resolver) -> bool | str | None:
    """As above, by the parameter files of a node."""
    sources = [resolver.readable(path) for path in node.parameters.files]
    if not any(source is None or _SIM_TIME.encode() in source.data for source in sources):
        return ""
    if None in sources or node.namespace != "":
        return None
    sections = (section for source in sources if source for section in node_parameters(source))
    values = [
        section.values.get(_SIM_TIME)
        for section in sections
        if section.path == (node.title,) and _SIM_TIME in section.values
    ]
    texts = {value.text.lower() if isinstance(value, Value) else "" for value in values}
    return {"true": True, "false": False}.get(texts.pop()) if len(texts) == 1 else None
