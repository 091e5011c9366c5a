"""Transforms and estimates that another program, or the simulation, publishes already."""

from collections.abc import Iterator

from urdfkit.checks.bringup.defined_controllers import defined_controllers
from urdfkit.checks.bringup.odometry import (
    OdometryTransform,
    of_bridges,
    of_cartographer,
    of_classic_plugins,
    of_drives,
    of_estimators,
    of_filters,
    of_global_filters,
)
from urdfkit.checks.bringup.published_robots import published_robots
from urdfkit.lint.rules import Context, Finding, Findings, Location, Related
from urdfkit.ros.launch.bridges import is_bridge
from urdfkit.ros.launch.contents import StartedProgram
from urdfkit.ros.launch.given_parameters import given_parameter, lacks_description
from urdfkit.ros.launch.spawned_controllers import topic_name
from urdfkit.ros.launch.transforms import static_transform
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value

_PUBLISHER = "robot_state_publisher"
#: Its parameter that begins the names of all frames, in ROS 2 and in ROS 1.
_PREFIXES = ("frame_prefix", "tf_prefix")
#: The nodes of robot_localization that estimate a state, and their topic.
_FILTERS, _FILTERED = ("ekf_node", "ukf_node"), "odometry/filtered"
#: A filter that publishes a transform by default.
_ORIENTATION = "imu_filter_madgwick/imu_filter_madgwick_node"
#: Root links that are global frames.
_WORLDS = ("world", "map", "odom")
#: Packages of programs that publish the transform from map to odom, and the parameter for it.
_LOCALIZING = {"nav2_amcl": "tf_broadcast", "slam_toolbox": "transform_publish_period"}
#: Their parameters for these two frames.
_FRAMES = {
    "nav2_amcl": ("global_frame_id", "odom_frame_id"),
    "slam_toolbox": ("map_frame", "odom_frame"),
}


def second_publisher(context: Context, programs: list[StartedProgram]) -> Findings:
    """A second robot_state_publisher of the same robot."""
    paths = {description.path for description in context.launch.descriptions}
    publishers = [node for node in programs if node.package == _PUBLISHER and _is_plain(node)]
    publishers = [node for node in publishers if not lacks_description(node)]
    for node in publishers[1:] if len(paths) == 1 and not context.launch.has_scopes else ():
        yield Finding(
            node.at,
            "a second robot_state_publisher publishes the transforms of the same robot",
            "remove one of the two",
            related=(Related(publishers[0].span, "the first is started here"),),
        )


def _is_plain(program: StartedProgram) -> bool:
    """True for a node without a namespace, remappings and a frame prefix."""
    is_known = program.namespace == "" and not program.is_remapped
    return is_known and not any(name in program.parameters.values for name in _PREFIXES)


def second_odometry(context: Context, programs: list[StartedProgram]) -> Findings:
    """A transform from odom to the robot by a filter or an estimator, and by something else."""
    of_each = list(of_filters(programs, context))
    filters = {transform.parent: transform for transform in reversed(of_each)}
    for transform in of_each if _share_transforms(context, programs) else ():
        if (other := filters[transform.parent]) is not transform:
            help = "set world_frame: map for the global one, or publish_tf: false"
            yield _twice(other, transform, transform.publisher, help)
    yield from _of_others(context, programs, filters)


def _of_others(
    context: Context, programs: list[StartedProgram], filters: dict[str, OdometryTransform]
) -> Findings:
    """The transforms of other programs, next to those of filters."""
    for estimator in of_estimators(programs, context):
        other = filters.setdefault(estimator.parent, estimator)
        if other is not estimator:
            yield _twice(other, estimator, estimator.publisher, "set its publish_tf: false")
    yield from _of_simulation(context, programs, filters) if filters else ()
    children = {transform.child: transform for transform in filters.values()}
    for slam in of_cartographer(programs, context):
        if filter := children.get(slam.child):
            help = f'write provide_odom_frame = false and published_frame = "{filter.parent}"'
            yield _twice(filter, slam, slam.publisher, help)
    for drive in of_drives(programs, defined_controllers(context)) if filters else ():
        if filter := filters.get(drive.parent):
            yield _twice(filter, drive, drive.publisher, "write enable_odom_tf: false")


def _share_transforms(context: Context, programs: list[StartedProgram]) -> bool:
    """True if all filters publish their transforms on /tf."""
    filters = [node for node in programs if node.executable in _FILTERS]
    return not context.launch.has_scopes and all(
        topic_name("/tf", node) == "/tf" for node in filters
    )


def _of_simulation(
    context: Context, programs: list[StartedProgram], filters: dict[str, OdometryTransform]
) -> Findings:
    """The transforms of plugins of Gazebo, next to those of filters."""
    for _, robot in context.described_robots:
        for bridged in of_bridges(programs, context, robot):
            if filter := filters.get(bridged.parent):
                publisher = f"{bridged.publisher} through the bridge"
                yield _twice(filter, bridged, publisher, "remove /tf from the bridge")
        for drive in of_classic_plugins(programs, robot):
            if filter := filters.get(drive.parent):
                help = "write <publish_odom_tf>false</publish_odom_tf>"
                yield _twice(filter, drive, drive.publisher, help)


def _twice(
    filter: OdometryTransform, other: OdometryTransform, publisher: str, help: str
) -> Finding:
    return Finding(
        other.at,
        f"the transform of '{filter.parent}' is published twice: by {publisher}, and by "
        f"{filter.publisher}",
        help,
        related=(Related(filter.at.span, f"{filter.publisher} is started here"),),
    )


def second_filter(context: Context, programs: list[StartedProgram]) -> Findings:
    """A second filter of robot_localization that publishes on the topic of the first."""
    first: dict[str, StartedProgram] = {}
    for node in programs if not context.launch.has_scopes else ():
        is_filter = node.package == "robot_localization" and node.executable in _FILTERS
        output = topic_name(_FILTERED, node) if is_filter else None
        other = first.setdefault(output, node) if output else node
        if other is not node:
            yield Finding(
                node.at,
                f"'{other.title}' and '{node.title}' both publish on '{output}'",
                f"remap {_FILTERED} of one of them",
                related=(Related(other.span, f"'{other.title}' is started here"),),
            )


def second_orientation(context: Context, programs: list[StartedProgram]) -> Findings:
    """A filter of an IMU that publishes the transform of the link of the IMU."""
    for node in programs:
        if node.key != _ORIENTATION or context.launch.has_scopes:
            continue
        is_published = given_parameter(node, "publish_tf", context.resolver)
        if is_published is None or is_published.lower() not in ("", "true"):
            continue
        frame = given_parameter(node, "fixed_frame", context.resolver) or "odom"
        links = [link for robot in published_robots(context) for link in robot.model.links]
        imu = next((link for link in links if "imu" in link.name.lower()), None)
        if imu is not None:
            yield Finding(
                node.at,
                f"'{node.title}' publishes the transform from {frame} to the frame of the IMU, and "
                f"robot_state_publisher that of '{imu.name}': a frame has one parent",
                "set publish_tf: false",
                related=(Related(imu.at.span, f"link '{imu.name}'"),),
            )


def static_odometry(context: Context, programs: list[StartedProgram]) -> Findings:
    """A static transform of the frame that odometry moves."""
    static = [(node, transform) for node in programs if (transform := static_transform(node))]
    if not static or context.launch.has_scopes:
        return
    moving = [*of_drives(programs, defined_controllers(context)), *of_filters(programs, context)]
    moving += _of_localization(programs, context)
    for _, robot in context.described_robots:
        moving += of_bridges(programs, context, robot)
    by_child = {odometry.child: odometry for odometry in moving if odometry.child}
    for node, transform in static:
        if odometry := by_child.get(transform.child.name):
            parent = transform.parent.name
            if parent == odometry.parent:
                help = "remove the static_transform_publisher"
            elif "base" in parent.lower():
                help = f"let {odometry.publisher} publish {odometry.parent} -> {parent}"
            else:
                help = f"publish that from {parent} to {odometry.parent}"
            yield Finding(
                Location(transform.child.span, node.frame),
                f"the transform of '{odometry.child}' is published twice: by this node, and by "
                f"{odometry.publisher}",
                help,
                related=(Related(odometry.at.span, "published here"),),
            )


def _of_localization(
    programs: list[StartedProgram], context: Context
) -> Iterator[OdometryTransform]:
    """The transforms from the map to odometry of programs that localize the robot."""
    for node in programs:
        if _localizes(node, context):
            keys = _FRAMES[node.package]
            parent, child = (given_parameter(node, key, context.resolver) for key in keys)
            if parent is not None and child is not None:
                publisher = f"'{node.executable}'"
                yield OdometryTransform(parent or "map", child or "odom", publisher, node.at)


def second_map(context: Context, programs: list[StartedProgram]) -> Findings:
    """A transform from map to odom by two programs that localize the robot."""
    localizing: dict[str, StartedProgram] = {}
    for node in programs if not context.launch.has_scopes else ():
        if _localizes(node, context):
            localizing.setdefault(node.package, node)
    if len(localizing) > 1:
        first, second = localizing.values()
        yield Finding(
            second.at,
            f"the transform from map to odom is published twice: by '{first.executable}' and by "
            f"'{second.executable}'",
            "start one of the two: SLAM to map, or localization in a map",
            related=(Related(first.span, f"'{first.executable}' is started here"),),
        )


def second_global_filter(context: Context, programs: list[StartedProgram]) -> Findings:
    """A transform from map to odom by robot_localization, and by AMCL or slam_toolbox."""
    filters = list(of_global_filters(programs, context))
    if not filters or not _share_transforms(context, programs):
        return
    localizing = {other.child: other for other in _of_localization(programs, context)}
    for filter in filters:
        if other := localizing.get(filter.child):
            yield Finding(
                filter.at,
                f"the transform from {filter.parent} to {filter.child} is published twice: by "
                f"{filter.publisher} and by {other.publisher}",
                f"write world_frame: {filter.child}, or publish_tf: false next to another filter",
                related=(Related(other.at.span, f"{other.publisher} is started here"),),
            )


def _localizes(program: StartedProgram, context: Context) -> bool:
    """True for a program that certainly publishes the transform from map to odom."""
    is_known = program.package in _LOCALIZING and _is_plain(program)
    return is_known and not _may_be_disabled(program, _LOCALIZING[program.package], context)


def _may_be_disabled(program: StartedProgram, switch: str, context: Context) -> bool:
    """True if a parameter disables the transforms of a program, or is unknown."""
    values = [value for key, value in program.parameters.values.items() if key == switch]
    for node in nodes_in_files(program.parameters.files, context.resolver):
        value = node.values.get(switch)
        values += [value.text if isinstance(value, Value) else None] if value is not None else []
    return any(value is None or value.lower() in ("false", "0", "0.0") for value in values)


def second_parent(context: Context, programs: list[StartedProgram]) -> Findings:
    """A transform of a link with a parent joint, by a filter or a bridge."""
    filters = list(of_filters(programs, context))
    robots = published_robots(context) if filters or any(map(is_bridge, programs)) else []
    roots = {root.name for robot in robots for root in robot.tree.roots}
    if len(roots) != 1 or roots.intersection(_WORLDS):
        return
    (root,) = roots
    bridged = of_bridges(programs, context, robots[0])
    for odometry in (*filters, *bridged):
        joints = [robot.tree.published_joint(odometry.child) for robot in robots]
        joint = joints[0] if all(joints) else None
        if joint is None or joint.parent_name == odometry.parent:
            continue
        is_bridged = odometry.named_at is not None
        yield Finding(
            odometry.named_at or odometry.at,
            f"{odometry.publisher} publishes the transform of '{odometry.child}'"
            f"{' through the bridge' if is_bridged else ''}, and robot_state_publisher that of "
            f"joint '{joint.name}': a frame has one parent",
            f"write {'' if is_bridged else 'base_link_frame: '}{root}, the root link",
            related=(Related(joint.at.span, f"joint '{joint.name}'"),),
        )
