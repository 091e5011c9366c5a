"""Nodes that wait for the time of a simulation, or use another time than it."""

from urdfkit.checks.bringup.gz_bridges import bridges_of_gz
from urdfkit.checks.bringup.unloaded_hardware import (
    CONTROL_NODE,
    MOCK,
    SIMULATED,
    may_be_simulated,
)
from urdfkit.checks.bringup.workspace_launches import is_included
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related, Severity
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.ros.ros_control import components
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.resolve import Resolver

_CLOCK = "clock"
_SLIDERS = "joint_state_publisher"
_SIM_TIME = "use_sim_time"
_PUBLISHER = "robot_state_publisher"
#: Launch files of ROS that start Gazebo and no bridge.
_GAZEBO = ("gz_sim.launch.py", "gz_server.launch.py", "gzserver.launch.py", "ign_gazebo.launch.py")


def missing_clock(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Nodes that use the time of a gz-sim whose clock is not bridged."""
    waiting = next((node for node in programs if _sim_time(node, context.resolver) is True), None)
    starts_gz = any(world.generation == GZ for world in worlds(context.launch))
    unread = (path.rpartition("/")[2] for path in context.launch.unread)
    if waiting is None or not starts_gz or not all(file in _GAZEBO for file in unread):
        return
    bridges = bridges_of_gz(programs)
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
    is_simulated = any(name == "/" or SIMULATED.search(name) for name in names)
    if is_simulated or any(map(model_spawner, programs)) or context.launch.unread:
        return
    robots = [robot.model for _, robot in context.described_robots]
    hardware = [component for model in robots for component in components(model)]
    is_real = all(one.hardware in MOCK or not may_be_simulated(one) for one in hardware)
    if not hardware or not is_real or is_included(context):
        return
    for node in programs:
        if node.executable != CONTROL_NODE or _SIM_TIME in node.parameters.values:
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
