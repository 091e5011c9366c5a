"""Programs of which the simulation, or another one, already does the work."""

from collections.abc import Iterator

from urdfkit.checks.launch.bridged_odometry import bridged_odometry
from urdfkit.checks.launch.defined_controllers import defined_controllers
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.node_parameters import node_parameters
from urdfkit.ros.launch.spawned_controllers import activates, controllers
from urdfkit.ros.launch.spawning import spawner_of
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.located_yaml import Value

_PUBLISHER = "robot_state_publisher"
_DRIVE = "diff_drive_controller/DiffDriveController"
#: Parameters of a filter, with their defaults.
_FILTER = {
    "publish_tf": "true",
    "odom_frame": "odom",
    "world_frame": "odom",
    "base_link_frame": "",  # base_link; a section that is not found may give another
}
_ODOM, _BASE = "odom_frame", "base_link_frame"
#: Roots that are frames of their own.
_WORLDS = ("world", "map", "odom")
#: Packages of programs that publish the transform from map to odom, and the parameter for it.
_LOCALIZING = {"nav2_amcl": "tf_broadcast", "slam_toolbox": "transform_publish_period"}
_FILTERS = {"ekf_node": "ekf_filter_node", "ukf_node": "ukf_filter_node"}


def second_publisher(context: Context, started: list[StartedProgram]) -> Findings:
    """A robot_state_publisher beside another one of the same robot."""
    paths = {description.path for description in context.launch.descriptions}
    found = [one for one in started if one.package == _PUBLISHER and _is_plain(one)]
    for one in found[1:] if len(paths) == 1 and not context.launch.has_scopes else ():
        yield Finding(
            Location(one.span, one.frame),
            "a second robot_state_publisher publishes the transforms of the same robot",
            "remove one of the two",
            related=(Related(found[0].span, "the first one is started here"),),
        )


def _is_plain(started: StartedProgram) -> bool:
    """True for a node without a namespace, other topics and other names of frames."""
    is_known = started.namespace == "" and not started.is_remapped
    return is_known and "frame_prefix" not in started.parameters.values


def second_manager(context: Context, started: list[StartedProgram]) -> Findings:
    """A controller manager beside the one that runs in Gazebo."""
    spawners = list(filter(spawner_of, started))
    if not spawners:
        return
    simulated = Related(spawners[0].span, "the robot is put into Gazebo here")
    nodes = [one for one in started if one.executable == "ros2_control_node"]
    for _, robot in context.described_robots if nodes else ():
        for plugin in control_plugins(robot.model):
            for one in nodes if "ros2_control" in (plugin.at.get("filename") or "") else ():
                yield Finding(
                    Location(one.span, one.frame),
                    "ros2_control_node is a second controller manager: Gazebo's plugin runs one",
                    "remove ros2_control_node where the robot is simulated",
                    related=(Related(plugin.at.span, "the plugin"), simulated),
                )


def second_odometry(context: Context, started: list[StartedProgram]) -> Findings:
    """The transform from odom to the robot by both a filter and a controller of wheels."""
    filters = {given[_ODOM]: one for one in started for given in _odometry_of(one, context)}
    if not filters:
        return
    for _, robot in context.described_robots:
        for found in bridged_odometry(context, started, robot):
            if filter := filters.get(found.odometry):
                yield Finding(
                    Location(found.bridge.span, found.bridge.frame),
                    f"the transform of '{found.odometry}' is published twice: by {found.who} "
                    f"through the bridge, and by '{filter.name or filter.executable}'",
                    "remove /tf from the bridge",
                    related=(Related(filter.span, "the filter is started here"),),
                )
    defined = defined_controllers(context)
    for one in started:
        for word in controllers(one) if activates(one) else ():
            controller = defined.get((word.text or "").strip("/"))
            if controller is None or controller.ros != 2 or controller.type != _DRIVE:
                continue
            section = controller.section
            written = [value.text for value in section.values("enable_odom_tf")]
            frames = [value.text for value in section.values("odom_frame_id")] or ["odom"]
            other = filters.get(frames[0].strip("/"))
            if other is None or "false" in map(str.lower, written):
                continue
            places = section.values("enable_odom_tf") or section.values("odom_frame_id")
            at = places[0].span if places else section.at or controller.type_at
            yield Finding(
                Location(at),
                f"the transform of '{frames[0]}' is published twice: by controller "
                f"'{controller.name}', and by '{other.name or other.executable}'",
                "write enable_odom_tf: false",
                related=(Related(other.span, "the filter is started here"),),
            )


def second_map(context: Context, started: list[StartedProgram]) -> Findings:
    """The transform from map to odom by two programs that localize the robot."""
    found: dict[str, StartedProgram] = {}
    for one in started if not context.launch.has_scopes else ():
        is_known = one.package in _LOCALIZING and _is_plain(one)
        if is_known and not _is_quiet(one, _LOCALIZING[one.package], context):
            found.setdefault(one.package, one)
    for one in list(found.values())[1:]:
        first = next(iter(found.values()))
        yield Finding(
            Location(one.span, one.frame),
            f"the transform from map to odom is published twice: by '{first.executable}' and by "
            f"'{one.executable}'",
            "start one of the two: SLAM to map, or localization in a map",
            related=(Related(first.span, f"'{first.executable}' is started here"),),
        )


def _is_quiet(started: StartedProgram, switch: str, context: Context) -> bool:
    """True if a parameter keeps a program from publishing transforms, or is not known."""
    values = [value for key, value in started.parameters.values.items() if key == switch]
    for path in started.parameters.files:
        source = context.resolver.readable(path)
        nodes = list(node_parameters(source)) if source else []
        written = [node.values[switch] for node in nodes if switch in node.values]
        values += [one.text if isinstance(one, Value) else None for one in written]
    return any(value is None or value.lower() in ("false", "0", "0.0") for value in values)


def second_parent(context: Context, started: list[StartedProgram]) -> Findings:
    """The transform of a link that a joint has as its child by a filter or a bridge, too."""
    launch = context.launch
    publishers = [one for one in started if one.package == _PUBLISHER and _is_plain(one)]
    filters = [(one, given) for one in started for given in _odometry_of(one, context)]
    if not publishers or len(launch.descriptions) != 1:
        return
    robot = context.other_robot(launch.descriptions[0].path, launch.descriptions[0].arguments)
    roots = robot.tree.roots if robot.reading.document and launch.descriptions[0].is_whole else ()
    if len(roots) != 1 or any(one.name in _WORLDS for one in roots):
        return
    above = robot.tree.parents
    for one, given in filters:
        joint = next(iter(above.get(given[_BASE], ())), None)
        if joint is None or joint.parent_name == given[_ODOM]:
            continue
        yield Finding(
            Location(one.span, one.frame),
            f"'{one.name or one.executable}' publishes the transform of '{given[_BASE]}', and so "
            f"does robot_state_publisher for joint '{joint.name}': a frame has one parent",
            f"write base_link_frame: {roots[0].name}, the root link",
            related=(Related(joint.at.span, f"joint '{joint.name}'"),),
        )
    for found in bridged_odometry(context, started, robot):
        joint = next(iter(above.get(found.base, ())), None)
        if joint is not None and joint.parent_name != found.odometry:
            yield Finding(
                found.child,
                f"{found.who} publishes the transform of '{found.base}' through the bridge, and "
                f"robot_state_publisher that of joint '{joint.name}': a frame has one parent",
                f"write {roots[0].name}, the root link",
                related=(Related(joint.at.span, f"joint '{joint.name}'"),),
            )


def _odometry_of(started: StartedProgram, context: Context) -> Iterator[dict[str, str]]:
    """The frames of a filter that publishes the transform from odometry to the robot."""
    if started.package != "robot_localization" or started.executable not in _FILTERS:
        return
    name = started.name or _FILTERS[started.executable]
    given = dict(_FILTER)
    is_known = started.parameters.is_whole and bool(started.parameters.files)
    for path in started.parameters.files:
        source = context.resolver.readable(path)
        if source is None:
            return
        for node in node_parameters(source):
            if node.name == name:
                values = {
                    key: one.text for key, one in node.values.items() if isinstance(one, Value)
                }
                given |= {key: values[key] for key in _FILTER if key in values}
    for key, text in started.parameters.values.items():
        is_known = is_known and (key not in _FILTER or text is not None)
        given[key] = text or ""
    is_same = given["world_frame"] == given["odom_frame"]
    if is_known and is_same and given["publish_tf"].lower() == "true":
        yield {key: text.strip("/") for key, text in given.items()}
