"""Nodes or hardware do not match the simulation that the launch file starts, or does not start.

- A filter or a planner uses the wall clock, while Gazebo and other nodes use simulation time
  (`use_sim_time`): its transforms are years newer than the data. An info for
  robot_state_publisher, which keeps the stamps of the joint states. Without Gazebo, a node with
  simulation time is reported if more nodes use the wall clock.
- Nodes use `use_sim_time`, but no bridge forwards Gazebo's `/clock`: their time stays zero. Or the
  controller manager of a robot that is not simulated uses it.
- Controllers are spawned in a gz sim that is started without `-r`: the simulation is paused, and
  no controller becomes active. An info without controllers.
- The `<ros2_control>` of a robot in Gazebo is `mock_components/GenericSystem`, which Gazebo's
  plugin does not load, or that of the real robot, although its files also name that of Gazebo. Or
  `ros2_control_node` runs hardware of Gazebo, but no robot is spawned in Gazebo: "class
  gz_ros2_control/GazeboSimSystem does not exist".
- The robot is spawned in gz-sim, but all its plugins are for Gazebo Classic, or the reverse.

A launch file is not checked if it includes unavailable files that are not part of ROS.

Sources:
    ROS 2, clock and time: https://design.ros2.org/articles/clock_and_time.html
    ros-controls/gz_ros2_control#474: https://github.com/ros-controls/gz_ros2_control/issues/474
    ros-controls/gz_ros2_control#720: https://github.com/ros-controls/gz_ros2_control/issues/720
    Ekumen-OS/andino_gz#39: https://github.com/Ekumen-OS/andino_gz/issues/39
"""

import os
from collections.abc import Sequence

from urdfkit.checks.bringup.gz_bridges import bridges_of_gz
from urdfkit.checks.bringup.known_programs import known_programs, running_programs
from urdfkit.checks.bringup.unloaded_hardware import (
    CONTROL_NODE,
    MOCK,
    SIMULATED,
    hardware_without_simulator,
    may_be_simulated,
    plugins_of_another_gazebo,
    unloaded_hardware,
)
from urdfkit.checks.bringup.workspace_launches import is_included
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.bridges import bridged_topics, is_bridge
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import spawned_controllers
from urdfkit.ros.launch.spawning import model_spawner
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.ros.node_parameters import node_parameters
from urdfkit.ros.ros_control import components
from urdfkit.text.located_yaml import Value
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "launch/simulation.launch.py"
BAD = """\
from launch.actions import ExecuteProcess
from launch_ros.actions import Node

actions = [
    ExecuteProcess(cmd=["gz", "sim", "empty.sdf"]),
    Node(package="ros_gz_sim", executable="create", arguments=["-string", "<robot/>"]),
    Node(package="controller_manager", executable="spawner", arguments=["arm_controller"]),
]
"""
GOOD = BAD.replace('"sim", ', '"sim", "-r", ')

_CLOCK = "clock"
_SLIDERS = "joint_state_publisher"
_SIM_TIME = "use_sim_time"
_PUBLISHER = "robot_state_publisher"
#: Programs that do not use the time of their node.
_TIMELESS = (("ros_gz_sim", "create"), ("ros_gz_bridge", "parameter_bridge"))
#: Launch files of ROS that start no bridge, besides those whose nodes are known.
_WITHOUT_BRIDGE = (
    "gz_sim.launch.py", "gz_server.launch.py", "gzserver.launch.py", "ign_gazebo.launch.py",
    "slam_launch.py", "rviz_launch.py",
)  # fmt: skip


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    programs = known_programs(context)
    yield from _wall_clock_nodes(context, programs)
    yield from _missing_clock(context)
    yield from _stopped_controllers(context, programs)
    yield from _paused(context, programs or running_programs(context))
    yield from unloaded_hardware(context, programs)
    yield from hardware_without_simulator(context, programs)
    yield from plugins_of_another_gazebo(context)


def _paused(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A gz sim that starts paused."""
    if not any(map(model_spawner, programs)):
        return
    running = [node for node in programs if node.is_sure]
    waiting = any(controller.is_activated for controller in spawned_controllers(running))
    for world in worlds(context.launch):
        if world.is_paused and world.is_sure:
            if not waiting and is_included(context):
                continue  # the including file may start controllers
            effect = "no controller becomes active" if waiting else "nothing moves"
            yield Finding(
                world.at,
                f"Gazebo starts paused: {effect} until Play is pressed",
                "write -r before the world",
                severity=None if waiting else Severity.INFO,
            )


def _missing_clock(context: Context) -> Findings:
    """Nodes that use the time of a gz-sim whose clock is not bridged."""
    optional = (node for node in context.launch.programs if not node.is_sure)
    if any(is_bridge(node) or not comes_with_ros(node.package) for node in optional):
        return
    programs = running_programs(context)
    timed = [node for node in programs if (node.package, node.executable) not in _TIMELESS]
    waiting = _waiting(timed, context.resolver)
    starts_gz = any(world.generation == GZ and world.is_sure for world in worlds(context.launch))
    if waiting is None or not starts_gz or not all(map(_starts_no_bridge, context.launch.unread)):
        return
    bridges = bridges_of_gz(programs)
    if bridges is None or _bridges_clock(bridges, context.resolver):
        return
    yield Finding(
        (bridges[0] if bridges else waiting).at,
        f"'{waiting.executable}' uses {_SIM_TIME}, but nothing publishes /clock: its time stays 0",
        "bridge /clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock",
    )


def _starts_no_bridge(path: str) -> bool:
    """True for an included file of ROS that starts no bridge."""
    is_shipped = path.removeprefix(f"{UNKNOWN}/") in data("launch")["shipped"]
    return is_shipped or path.rpartition("/")[2] in _WITHOUT_BRIDGE


def _stopped_controllers(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """A controller manager of a robot, or of mock hardware, with the time of a simulation."""
    names = [node.key for node in programs]
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
                is_own = section.are_of(node.name or "controller_manager")
                if (
                    is_own
                    and not section.namespace.strip("/")
                    and isinstance(value, Value)
                    and value.boolean
                ):
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


def _wall_clock_nodes(context: Context, programs: tuple[StartedProgram, ...]) -> Findings:
    """Nodes without simulation time, while other nodes use it."""
    running = running_programs(context)
    is_simulated = any(map(model_spawner, running))
    if is_simulated:
        programs = running  # other choices, such as that of the real robot, run no Gazebo
    if context.launch.has_scopes or (context.launch.sets_sim_time and not is_simulated):
        return
    resolver = context.resolver
    other = _waiting(programs, resolver)
    if other is not None and not is_simulated and (most := _most(programs, resolver)):
        yield Finding(
            other.at,
            f"{_SIM_TIME} of '{other.executable}' is true, unlike that of '{most[0].executable}' "
            f"and {len(most) - 1} more",
            f'give it {{"{_SIM_TIME}": False}}, or all others True',
        )
        return
    for node in programs:
        severity = data("nodes")["stamping"].get(node.package)
        is_slider = node.package.startswith(_SLIDERS) and not is_simulated
        if severity is None or is_slider or not node.is_sure:
            continue
        needs_time = is_simulated or severity == Severity.WARNING.value
        if message := _wrong_clock(context, node, other, is_simulated, needs_time=needs_time):
            help = f'give it {{"{_SIM_TIME}": True}}'
            if node.frame is not None and _SIM_TIME in node.parameters.values:
                help += f", or pass {_SIM_TIME} to {os.path.basename(node.span.source.path)}"
            yield Finding(node.at, message, help, severity=Severity(severity))


def _wrong_clock(
    context: Context,
    node: StartedProgram,
    other: StartedProgram | None,
    is_simulated: bool,
    *,
    needs_time: bool,
) -> str:
    """The message about a node with the wall clock; empty if it has the right clock, or may have.

    Args:
        other: a node with simulation time.
        is_simulated: True if a robot is spawned in Gazebo.
    """
    own = _sim_time(node, context.resolver)
    if own is False and is_simulated and (other is not None or node.package == _PUBLISHER):
        return f"{_SIM_TIME} of {node.executable} is false, but Gazebo is started"
    if other is None or not needs_time:
        return ""
    if own is False:
        return f"{_SIM_TIME} of {node.executable} is false, unlike that of '{other.executable}'"
    if own == "" and not context.launch.sets_sim_time:
        return f"{node.executable} lacks {_SIM_TIME}, which '{other.executable}' sets"
    return ""


def _most(programs: Sequence[StartedProgram], resolver: Resolver) -> list[StartedProgram]:
    """The nodes that use the wall clock, if they are more than those with simulation time.

    None if their messages have no stamps.
    """
    running = [(node, _sim_time(node, resolver)) for node in programs if node.is_sure]
    real = [node for node, is_simulated in running if is_simulated is False]
    simulated = [node for node, is_simulated in running if is_simulated is True]
    severities = {data("nodes")["stamping"].get(node.package) for node in real}
    is_stamped = Severity.WARNING.value in severities
    return real if is_stamped and len(real) > len(simulated) else []


def _waiting(programs: Sequence[StartedProgram], resolver: Resolver) -> StartedProgram | None:
    """The first program that certainly runs, and uses simulation time."""
    running = (node for node in programs if node.is_sure)
    return next((node for node in running if _sim_time(node, resolver) is True), None)


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
