"""Nodes that wait for the time of the simulation, or do not follow it."""

from collections.abc import Iterable

from urdfkit.errors import UnreadableFile
from urdfkit.lint.rules import Context, Finding, Findings, Location, Severity
from urdfkit.ros.launch.bridges import bridged_topics, is_bridge
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.spawned_controllers import activates, controllers
from urdfkit.ros.launch.spawning import spawner_of
from urdfkit.ros.launch.worlds import GZ, worlds
from urdfkit.workspace.resolve import Resolver

_CLOCK = "clock"
_SIM_TIME = "use_sim_time"
#: Packages whose nodes give or compare stamps, and how much worse it is if they use another clock.
#: robot_state_publisher passes on the stamps of the joint states.
_STAMPING = {
    "robot_state_publisher": Severity.INFO,
    "robot_localization": Severity.WARNING,
    "slam_toolbox": Severity.WARNING,
    "nav2_amcl": Severity.WARNING,
    "nav2_controller": Severity.WARNING,
    "nav2_planner": Severity.WARNING,
    "moveit_ros_move_group": Severity.WARNING,
    "rviz2": Severity.INFO,
}
#: Launch files of ROS that start Gazebo and no bridge.
_GAZEBO = ("gz_sim.launch.py", "gz_server.launch.py", "gzserver.launch.py", "ign_gazebo.launch.py")


def without_clock(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Nodes by the time of a gz-sim that is started here, where no bridge passes that time on."""
    if not any(world.generation == GZ for world in worlds(context.launch)):
        return
    unread = (path.rpartition("/")[2] for path in context.launch.unread)
    is_gz = any(one.package == "ros_gz_sim" and spawner_of(one) for one in started)
    waiting = next((one for one in started if _sim_time(one, context.resolver) is True), None)
    if not is_gz or waiting is None or not all(file in _GAZEBO for file in unread):
        return
    bridges = [one for one in started if is_bridge(one)]
    if not all(_is_known(one) for one in bridges):
        return
    passed = [topic for one in bridges for topic in bridged_topics(one, context.resolver)]
    is_remapped = any(one.is_remapped for one in bridges)
    if any(topic.ros_topic.strip("/") == _CLOCK for topic in passed) or (
        is_remapped and any(topic.ros_type.endswith("/Clock") for topic in passed)
    ):
        return
    where = bridges[0] if bridges else waiting
    message = f"nothing publishes /clock, for which '{waiting.executable}' waits with {_SIM_TIME}"
    help = "bridge /clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"
    yield Finding(Location(where.span, where.frame), message, help)


def by_wall_clock(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """Nodes without the time of Gazebo, where others have it."""
    if context.launch.has_scopes or not any(map(spawner_of, started)):
        return
    resolver = context.resolver
    other = next((one for one in started if _sim_time(one, resolver) is True), None)
    for one in started:
        severity = _STAMPING.get(one.package)
        own = _sim_time(one, resolver) if severity else None
        if own is None or own is True:
            continue
        if own is False and (other is not None or one.package == "robot_state_publisher"):
            message = f"{_SIM_TIME} of {one.executable} is false, though Gazebo gives the time"
        elif other is not None:
            message = f"{one.executable} has no {_SIM_TIME}, which '{other.executable}' has"
        else:
            continue
        help = f'give it {{"{_SIM_TIME}": True}}'
        yield Finding(Location(one.span, one.frame), message, help, severity=severity)


def paused(context: Context, started: tuple[StartedProgram, ...]) -> Findings:
    """A gz sim that stands still until somebody presses its button."""
    if not any(map(spawner_of, started)):
        return
    waiting = any(activates(one) and any(True for _ in controllers(one)) for one in started)
    for world in worlds(context.launch):
        if world.is_paused and world.is_sure:
            who = "no controller becomes active" if waiting else "nothing moves"
            yield Finding(
                Location(world.span, world.frame),
                f"Gazebo starts paused: {who} before somebody presses its button",
                "write -r before the world",
                severity=None if waiting else Severity.INFO,
            )


def _is_known(bridge: StartedProgram) -> bool:
    """True if all is known that a bridge passes on."""
    has_file = bridge.parameters.values.get("config_file", "") is not None
    is_whole = bridge.parameters.every is not None
    return has_file and is_whole and all(word.text is not None for word in bridge.words)


def _sim_time(one: StartedProgram, resolver: Resolver) -> bool | str | None:
    """Whether a node uses the time of the simulation.

    Returns:
        None if that is not known; an empty text where nothing is said, so that it does not.
    """
    given = one.parameters.values.get(_SIM_TIME, "")
    if _SIM_TIME in one.parameters.values:
        return {"true": True, "false": False}.get((given or "").lower())
    said = any(_SIM_TIME in (word.text or _SIM_TIME) for word in one.words)
    if said or not one.parameters.is_whole or _is_in_file(one.parameters.files, resolver):
        return None
    return ""


def _is_in_file(paths: Iterable[str], resolver: Resolver) -> bool:
    for path in paths:
        try:
            if _SIM_TIME.encode() in resolver.read(path).data:
                return True
        except UnreadableFile:
            return True
    return False
