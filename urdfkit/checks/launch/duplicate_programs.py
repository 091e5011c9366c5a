"""Programs whose work the simulation, or another program, does already.

Source: ``DiffDrive.cc`` and ``OdometryPublisher.cc`` of gz-sim.
"""

from __future__ import annotations

from collections.abc import Iterator

from urdfkit.checks.launch.defined_controllers import defined_controllers
from urdfkit.core.record import Record
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.controllers import Controller
from urdfkit.ros.gazebo.topics import of_plugin
from urdfkit.ros.launch.bridges import TO_GAZEBO, bridged_topics
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.node_parameters import node_parameters
from urdfkit.ros.launch.spawned_controllers import activates, controllers
from urdfkit.ros.launch.spawning import spawner_of
from urdfkit.ros.launch.transforms import static_transform
from urdfkit.ros.ros_control import control_plugins
from urdfkit.text.document import Element
from urdfkit.text.located_yaml import Value
from urdfkit.text.source import Span

_PUBLISHER = "robot_state_publisher"
_DRIVE = "diff_drive_controller/DiffDriveController"
#: Parameters of a filter, with their defaults.
_FILTER = {
    "publish_tf": "true",
    "odom_frame": "odom",
    "world_frame": "odom",
    "base_link_frame": "",  # base_link by default, but a section that is not found may set it
}
_ODOM, _BASE = "odom_frame", "base_link_frame"
#: Root links that are global frames.
_WORLDS = ("world", "map", "odom")
#: Packages of programs that publish the transform from map to odom, and the parameter for it.
_LOCALIZING = {"nav2_amcl": "tf_broadcast", "slam_toolbox": "transform_publish_period"}
_FILTERS = {"ekf_node": "ekf_filter_node", "ukf_node": "ukf_filter_node"}

#: Tags of Gazebo's plugins for the parent and the child frame of odometry.
_PARENTS, _CHILDREN = ("frame_id", "odom_frame"), ("child_frame_id", "robot_base_frame")


class _BridgedOdometry(Record):
    """The transform of odometry that a plugin of Gazebo publishes and a bridge forwards to tf."""

    bridge: StartedProgram
    who: str  # the plugin, for messages
    odometry: str  # the parent frame; empty if the plugin does not name it
    child: Element  # names the child frame

    @property
    def base(self) -> str:
        return self.child.text.strip().strip("/")


def second_publisher(context: Context, started: list[StartedProgram]) -> Findings:
    """A second robot_state_publisher of the same robot."""
    paths = {description.path for description in context.launch.descriptions}
    publishers = [node for node in started if node.package == _PUBLISHER and _is_plain(node)]
    for node in publishers[1:] if len(paths) == 1 and not context.launch.has_scopes else ():
        yield Finding(
            Location(node.span, node.frame),
            "a second robot_state_publisher publishes the transforms of the same robot",
            "remove one of the two",
            related=(Related(publishers[0].span, "the first is started here"),),
        )


def _is_plain(started: StartedProgram) -> bool:
    """True for a node without a namespace, remappings and a frame prefix."""
    is_known = started.namespace == "" and not started.is_remapped
    return is_known and "frame_prefix" not in started.parameters.values


def second_manager(context: Context, started: list[StartedProgram]) -> Findings:
    """A second controller manager, next to that of Gazebo's plugin."""
    spawners = list(filter(spawner_of, started))
    if not spawners:
        return
    simulated = Related(spawners[0].span, "the robot is spawned in Gazebo here")
    nodes = [node for node in started if node.executable == "ros2_control_node"]
    for _, robot in context.described_robots if nodes else ():
        for plugin in control_plugins(robot.model):
            for node in nodes if "ros2_control" in (plugin.at.get("filename") or "") else ():
                yield Finding(
                    Location(node.span, node.frame),
                    "ros2_control_node is a second controller manager: Gazebo's plugin runs one",
                    "remove ros2_control_node from launch files with Gazebo",
                    related=(Related(plugin.at.span, "the plugin"), simulated),
                )


def second_odometry(context: Context, started: list[StartedProgram]) -> Findings:
    """A transform from odom to the robot by a filter, and by a controller or a bridge."""
    filters = {frames[_ODOM]: node for node in started for frames in _filter_frames(node, context)}
    if not filters:
        return
    for _, robot in context.described_robots:
        for bridged in _bridged_odometry(context, started, robot):
            if filter := filters.get(bridged.odometry):
                yield Finding(
                    Location(bridged.bridge.span, bridged.bridge.frame),
                    f"the transform of '{bridged.odometry}' is published twice: by {bridged.who} "
                    f"through the bridge, and by '{filter.name or filter.executable}'",
                    "remove /tf from the bridge",
                    related=(Related(filter.span, "the filter is started here"),),
                )
    for controller, odometry, _ in _publishing_drives(context, started):
        if other := filters.get(odometry):
            section = controller.section
            places = section.values("enable_odom_tf") or section.values("odom_frame_id")
            at = places[0].span if places else section.at or controller.type_at
            yield Finding(
                at,
                f"the transform of '{odometry}' is published twice: by controller "
                f"'{controller.name}', and by '{other.name or other.executable}'",
                "write enable_odom_tf: false",
                related=(Related(other.span, "the filter is started here"),),
            )


def _publishing_drives(
    context: Context, started: list[StartedProgram]
) -> Iterator[tuple[Controller, str, str]]:
    """The drives that publish a transform, its parent and its child."""
    defined = defined_controllers(context)
    for node in started:
        for word in controllers(node) if activates(node) else ():
            controller = defined.get((word.text or "").strip("/"))
            if controller is None or controller.ros != 2 or controller.type != _DRIVE:
                continue
            values = controller.section.values
            if "false" not in [value.text.lower() for value in values("enable_odom_tf")]:
                odometry = [value.text.strip("/") for value in values("odom_frame_id")]
                base = [value.text.strip("/") for value in values("base_frame_id")]
                yield controller, (odometry or ["odom"])[0], (base or ["base_link"])[0]


def static_odometry(context: Context, started: list[StartedProgram]) -> Findings:
    """A static transform of the frame that odometry moves."""
    static = [(node, found) for node in started if (found := static_transform(node))]
    if not static or context.launch.has_scopes:
        return
    moved: dict[str, tuple[str, str, Span]] = {}
    for drive, parent, child in _publishing_drives(context, started):
        moved[child] = (parent, f"controller '{drive.name}'", drive.section.at or drive.type_at)
    for filter in started:
        for frames in _filter_frames(filter, context):
            who = f"'{filter.name or filter.executable}'"
            moved[frames[_BASE]] = (frames[_ODOM], who, filter.span)
    for _, robot in context.described_robots:
        for bridged in _bridged_odometry(context, started, robot):
            moved[bridged.base] = (bridged.odometry, bridged.who, bridged.bridge.span)
    for node, transform in static:
        child = (transform.child.text or "").strip("/")
        parent = (transform.parent.text or "").strip("/")
        if child in moved and child:
            odometry, who, at = moved[child]
            remove = "remove the static_transform_publisher"
            yield Finding(
                Location(transform.child.span, node.frame),
                f"the transform of '{child}' is published twice: by this node, and by {who}",
                remove if parent == odometry else f"publish that from {parent} to {odometry}",
                related=(Related(at, "published here"),),
            )


def second_map(context: Context, started: list[StartedProgram]) -> Findings:
    """A transform from map to odom by two programs that localize the robot."""
    programs: dict[str, StartedProgram] = {}
    for node in started if not context.launch.has_scopes else ():
        is_known = node.package in _LOCALIZING and _is_plain(node)
        if is_known and not _may_be_disabled(node, _LOCALIZING[node.package], context):
            programs.setdefault(node.package, node)
    for node in list(programs.values())[1:]:
        first = next(iter(programs.values()))
        yield Finding(
            Location(node.span, node.frame),
            f"the transform from map to odom is published twice: by '{first.executable}' and by "
            f"'{node.executable}'",
            "start one of the two: SLAM to map, or localization in a map",
            related=(Related(first.span, f"'{first.executable}' is started here"),),
        )


def _may_be_disabled(started: StartedProgram, switch: str, context: Context) -> bool:
    """True if a parameter disables the transforms of a program, or is unknown."""
    values = [value for key, value in started.parameters.values.items() if key == switch]
    for path in started.parameters.files:
        source = context.resolver.readable(path)
        nodes = list(node_parameters(source)) if source else []
        written = [node.values[switch] for node in nodes if switch in node.values]
        values += [each.text if isinstance(each, Value) else None for each in written]
    return any(value is None or value.lower() in ("false", "0", "0.0") for value in values)


def second_parent(context: Context, started: list[StartedProgram]) -> Findings:
    """A transform of a link with a parent joint, by a filter or a bridge."""
    launch = context.launch
    publishers = [node for node in started if node.package == _PUBLISHER and _is_plain(node)]
    filters = [(node, frames) for node in started for frames in _filter_frames(node, context)]
    if not publishers or len(launch.descriptions) != 1:
        return
    robot = context.other_robot(launch.descriptions[0].path, launch.descriptions[0].arguments)
    roots = robot.tree.roots if robot.reading.document and launch.descriptions[0].is_whole else ()
    if len(roots) != 1 or any(root.name in _WORLDS for root in roots):
        return
    above = robot.tree.parents
    for node, frames in filters:
        joint = next(iter(above.get(frames[_BASE], ())), None)
        if joint is None or joint.parent_name == frames[_ODOM]:
            continue
        yield Finding(
            Location(node.span, node.frame),
            f"'{node.name or node.executable}' publishes the transform of '{frames[_BASE]}', and "
            f"so does robot_state_publisher for joint '{joint.name}': a frame has one parent",
            f"write base_link_frame: {roots[0].name}, the root link",
            related=(Related(joint.at.span, f"joint '{joint.name}'"),),
        )
    for bridged in _bridged_odometry(context, started, robot):
        joint = next(iter(above.get(bridged.base, ())), None)
        if joint is not None and joint.parent_name != bridged.odometry:
            yield Finding(
                bridged.child,
                f"{bridged.who} publishes the transform of '{bridged.base}' through the bridge, "
                f"and robot_state_publisher that of joint '{joint.name}': a frame has one parent",
                f"write {roots[0].name}, the root link",
                related=(Related(joint.at.span, f"joint '{joint.name}'"),),
            )


def _filter_frames(started: StartedProgram, context: Context) -> Iterator[dict[str, str]]:
    """The frames of a filter that publishes the transform from odometry to the robot."""
    if started.package != "robot_localization" or started.executable not in _FILTERS:
        return
    name = started.name or _FILTERS[started.executable]
    frames = dict(_FILTER)
    is_known = started.parameters.is_whole and bool(started.parameters.files)
    for path in started.parameters.files:
        source = context.resolver.readable(path)
        if source is None:
            return
        for node in node_parameters(source):
            if node.name == name:
                values = ((key, node.values.get(key)) for key in _FILTER)
                frames |= {key: value.text for key, value in values if isinstance(value, Value)}
    for key, text in started.parameters.values.items():
        is_known = is_known and (key not in _FILTER or text is not None)
        frames[key] = text or ""
    is_same = frames["world_frame"] == frames["odom_frame"]
    if is_known and is_same and frames["publish_tf"].lower() == "true":
        yield {key: text.strip("/") for key, text in frames.items()}


def _bridged_odometry(
    context: Context, started: list[StartedProgram], robot: Context
) -> Iterator[_BridgedOdometry]:
    for node in started:
        for topic in bridged_topics(node, context.resolver):
            if topic.direction == TO_GAZEBO or topic.ros_topic.strip("/") != "tf":
                continue
            for use in robot.plugins:
                child = _first_child(use.at, _CHILDREN)
                publishes = any(
                    gz_topic.message == "Pose_V" and gz_topic.is_called(topic.topic)
                    for gz_topic in of_plugin(use.at)
                )
                if child is not None and publishes and node.is_sure and not node.is_remapped:
                    parent = _first_child(use.at, _PARENTS)
                    odometry = parent.text.strip().strip("/") if parent is not None else ""
                    yield _BridgedOdometry(node, use.title, odometry, child)


def _first_child(plugin: Element, tags: tuple[str, ...]) -> Element | None:
    return next((child for tag in tags if (child := plugin.child(tag)) is not None), None)
