"""A parameter file, RViz or a static transform names a frame that nothing publishes.

tf has the links of the robot from robot_state_publisher, the children of static transforms, and
`map`, `odom` and `world` from localization and odometry. With any other name robot_localization,
Nav2 and slam_toolbox wait for ever: "Could not find a connection between 'odom' and 'base'", "Timed
out waiting for transform from base to map". RViz shows nothing: "Fixed Frame [base] does not
exist". A static transform with such a parent creates a second tree.

Checked are:

- `base_link_frame`, `base_link_output_frame`, `robot_base_frame`, `base_frame`, `base_frame_id` and
  `sensor_frame`. slam_toolbox and AMCL without such a parameter use `base_footprint`. In Nav2 none
  may begin with a slash ("frame_ids cannot start with a '/'").
- `tracking_frame` and `published_frame` of Cartographer, `box_frame` and `polygon_frame` of
  laser_filters.
- RViz's fixed frame and the frames of its displays. `map`, `odom` and `world` as the fixed frame
  are reported if a launch file starts only RViz with joint_state_publisher, and `world` in one with
  navigation whose own programs publish no transforms.
- Parents of static transforms, unless the launch file starts drivers that are not in the workspace,
  which may publish other frames.
- The `global_frame` of a costmap, only for typos of `map` or `odom`.
- The frames in which drivers of lidars and cameras publish, next to the robot or to navigation.
- The frame of odometry of AMCL and slam_toolbox, if robot_localization, or without it the wheel
  controller, publishes another one.
- A `world_frame` of robot_localization that is neither its `odom_frame` nor its `map_frame`, and an
  `odom_frame` that equals another frame: the filter stops ("Invalid frame configuration!").

The `frame_prefix` of robot_state_publisher counts, if it is the same everywhere.

The robots are those of the launch file, otherwise those of the other launch files of the workspace.
Frames that a program of the workspace names are not reported, `map`, `odom` and `world` if it
publishes transforms; nor, in the launch file of a driver, parents whose last word its program
appends.

Sources:
    REP 105, coordinate frames: https://www.ros.org/reps/rep-0105.html
    robot_localization, parameters: https://github.com/cra-ros-pkg/robot_localization/blob/ros2/params/ekf.yaml
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    slam_toolbox, slam_toolbox_common.cpp: https://github.com/SteveMacenski/slam_toolbox/blob/ros2/src/slam_toolbox_common.cpp
    RViz, frame_manager.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_common/src/rviz_common/frame_manager.cpp
"""

import re
from collections.abc import Iterable, Iterator

from urdfkit.checks.bringup.defined_controllers import controllers_of_workspace
from urdfkit.checks.bringup.odometry import OdometryTransform, of_drives, of_filters
from urdfkit.checks.bringup.published_frames import (
    WELL_KNOWN,
    links_of_robots,
    may_have_other_publishers,
    published_frames,
    static_transforms,
)
from urdfkit.checks.bringup.workspace_launches import all_launches, programs_of
from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.launch.bridges import bridged_topics
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.frames import (
    FRAMES,
    GLOBAL,
    NamedFrame,
    default_frames,
    frames_of_cartographer,
    named_frames,
    sensor_frames,
)
from urdfkit.ros.launch.transforms import static_transform
from urdfkit.ros.node_parameters import nodes_in_files
from urdfkit.text.located_yaml import Value, entries, scalar
from urdfkit.workspace.program_strings import strings_in_programs
from urdfkit.workspace.ros_packages import comes_with_ros

NAME = "launch/filter.launch.py"
BAD = """\
from launch_ros.actions import Node

nodes = [
    Node(
        package="robot_state_publisher",
        executable="robot_state_publisher",
        parameters=[{"robot_description": open("../robot.urdf").read()}],
    ),
    Node(package="robot_localization", executable="ekf_node", parameters=["../base.yaml"]),
]
"""
GOOD = BAD.replace("base.yaml", "base_link.yaml")
_FILTER = b"ekf_filter_node:\n  ros__parameters:\n    base_link_frame: %s\n"
FILES = {
    "robot.urdf": b'<robot name="r"><link name="base_link"/></robot>',
    "base.yaml": _FILTER % b"base",
    "base_link.yaml": _FILTER % b"base_link",
    "package.xml": b"<package><name>arm</name></package>",
}

#: Usual global frames of a costmap.
_GLOBAL = ("map", "odom")
_MAX_NAMED = 4
#: Nodes that need the frame of odometry, with their parameter for it, and those of publishers.
_ODOMETRY_OF = {
    "amcl": "odom_frame_id",
    "collision_monitor": "odom_frame_id",
    "slam_toolbox": "odom_frame",
}
_ODOMETRY_KEYS = ("odom_frame", "odom_frame_id", "odometry_frame")
#: Gazebo Classic, whose plugins publish transforms themselves.
_SPAWNERS = ("spawn_entity.py", "spawn_model")
#: An absolute name of several parts: tf2 rejects frames with a leading slash.
_TOPIC = re.compile(r"/\w+/")
#: Nodes of Nav2, which look up frames as they are; robot_localization removes a leading slash.
_OF_NAV2 = ("amcl", "behavior_server", "bt_navigator", "global_costmap", "local_costmap")
#: What a program has that publishes transforms: others name `map` as the frame of their messages.
_BROADCASTS = rb"TransformBroadcaster|sendTransform|TFMessage|tf2_msgs"
#: Packages whose programs publish no frames of sensors, and those that need these frames.
_PLAIN = re.compile(
    r"controller_manager|joint_state_publisher(_gui)?|joy(_linux)?|ros_gz_\w+|rviz2|tf2_ros"
    r"|twist_mux|teleop_twist_(joy|keyboard)|rplidar_ros|sllidar_ros2|ldlidar_stl_ros2|urg_node2"
    r"|ydlidar_ros2_driver|depthimage_to_laserscan|usb_cam|velodyne_\w+|laser_filters"
    r"|pointcloud_to_laserscan|imu_filter_madgwick|explore_lite|bno055|rtabmap_(slam|odom|sync|viz)"
    r"|robot_state_publisher|robot_localization|slam_toolbox|nav2_\w+|micro_ros_agent|xacro"
)
_LOCATED = re.compile(r"robot_state_publisher|robot_localization|slam_toolbox|nav2_\w+")


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    launch = context.launch
    readers = (named_frames, default_frames, frames_of_cartographer)
    frames = [frame for read in readers for frame in read(launch, context.resolver)]
    if all(_PLAIN.fullmatch(node.package) for node in launch.programs) and any(
        _LOCATED.fullmatch(node.package) for node in launch.programs
    ):
        frames += sensor_frames(launch, context.resolver)
    if not frames and not any(True for _ in static_transforms(launch)):
        return
    if known := published_frames(context):
        known |= _frames_of_filters(launch, frames)
        yield from _unpublished(context, frames, known)
    yield from _with_slash(context)
    yield from _wrong_filter_frames(context)
    yield from _unpublished_odometry(context)


def _with_slash(context: Context) -> Findings:
    """Frames of Nav2 with a leading slash, which tf2 rejects."""
    paths = dict.fromkeys(file.path for file in context.launch.parameters)
    for node in nodes_in_files(list(paths), context.resolver):
        for key, value in entries(node.values) if node.name in _OF_NAV2 else ():
            if key in FRAMES and isinstance(value, Value) and value.text.startswith("/"):
                message = f"{key} '{value.text}' begins with a slash, which tf2 rejects"
                yield Finding(value.span, message, f"write {value.text.lstrip('/')}")


def _unpublished(context: Context, frames: list[NamedFrame], known: frozenset[str]) -> Findings:
    """Frames and parents of transforms that nothing publishes, and that no program names."""
    launch = context.launch
    overridden = {key for node in launch.programs for key in node.parameters.values}
    last_words = {name.rpartition("/")[2] for name in known}
    frames_of_drivers = _frames_of_drivers(launch)
    unknown = [
        frame
        for frame in frames
        if frame.name not in known
        and (frame.named_at is None or frame.key not in overridden)
        and (frame.key or frame.name not in frames_of_drivers)
        and not _is_in_namespace(frame, launch, last_words)
        and (frame.key != GLOBAL or _is_typo(frame, frames))
    ]
    parents = {}
    if not may_have_other_publishers(context):
        parents = dict(_unknown_parents(launch, known, links_of_robots(context, (launch,))))
    suffixes = _suffixes(parents, launch)
    words = {*(frame.name for frame in unknown), *parents, *suffixes.values()}
    elsewhere = strings_in_programs(words - WELL_KNOWN, context.source.path, context.resolver)
    elsewhere |= strings_in_programs(
        words & WELL_KNOWN, context.source.path, context.resolver, _BROADCASTS
    )
    yield from (_finding(frame, known) for frame in unknown if frame.name not in elsewhere)
    for name, finding in parents.items():
        if elsewhere.isdisjoint((name, suffixes.get(name, name))):
            yield finding


def _suffixes(names: Iterable[str], launch: Launch) -> dict[str, str]:
    """What a driver of the workspace may append to its own name: ``_link`` of ``camera1_link``."""
    has_driver = any(node.package and not comes_with_ros(node.package) for node in launch.programs)
    if launch.descriptions or not has_driver:
        return {}
    return {name: "_" + name.rpartition("_")[2] for name in names if "_" in name}


def _is_in_namespace(frame: NamedFrame, launch: Launch, last_words: set[str]) -> bool:
    """True for a frame that a robot may publish in the namespace of another launch file."""
    _, namespace, last = frame.name.rpartition("/")
    if frame.key:
        return bool(namespace and not launch.descriptions)
    return bool(namespace and last in last_words)


def _is_typo(frame: NamedFrame, frames: list[NamedFrame]) -> bool:
    """True for a frame that is named once and resembles ``map`` or ``odom``."""
    uses = sum(other.name == frame.name for other in frames)
    return uses == 1 and nearest(frame.name, _GLOBAL) is not None


def _frames_of_drivers(launch: Launch) -> frozenset[str]:
    """Values of frame parameters: nodes stamp messages with them, and RViz shows these."""
    return frozenset(
        value.lstrip("/")
        for node in launch.programs
        for key, value in node.parameters.values.items()
        if value and "frame" in key
    )


def _frames_of_filters(launch: Launch, frames: list[NamedFrame]) -> frozenset[str]:
    """Base frames of filters that are parents of static transforms."""
    parents = {transform.parent.name for transform in static_transforms(launch)}
    return frozenset(frame.name for frame in frames if frame.key == "base_link_frame") & parents


def _finding(frame: NamedFrame, known: frozenset[str]) -> Finding:
    is_global = frame.key == GLOBAL or (frame.name in WELL_KNOWN - known and "map" in known)
    published = sorted(_GLOBAL if is_global else known - WELL_KNOWN)
    is_default = frame.named_at is None
    prefixed = next((name for name in published if name.endswith(f"/{frame.name}")), "")
    help = f"{f'set {frame.key} to' if is_default else 'name'} a frame that is published: "
    help += few(published, _MAX_NAMED)
    if prefixed:
        help = f"write {prefixed}, or remove the frame_prefix of robot_state_publisher"
    note = () if frame.named_at is None else (Related(frame.named_at, "the file is named here"),)
    return Finding(
        frame.span,
        f"{frame.who} '{frame.name}' is neither a link of the robot nor a static transform"
        f"{did_you_mean(frame.name, published)}",
        help,
        related=note,
    )


def _unknown_parents(
    launch: Launch, known: frozenset[str], of_robot: frozenset[str]
) -> Iterator[tuple[str, Finding]]:
    """Parents of static transforms that create a second tree, except that of the robot's root."""
    for node in launch.started:
        transform = static_transform(node)
        if transform is None:
            continue
        name, child = transform.parent.name, transform.child.name
        # Gazebo's plugins publish frames as MODEL/FRAME.
        is_known = name in known or name.rpartition("/")[2] in known
        if name and not is_known and child not in of_robot:
            message = f"parent '{name}' of the static transform is not a link of the robot"
            message += did_you_mean(name, known - {child})
            help = f"name a frame that is published: {few(sorted(known - WELL_KNOWN), _MAX_NAMED)}"
            yield name, Finding(Location(transform.parent.span, node.frame), message, help)


def _unpublished_odometry(context: Context) -> Findings:
    """Frames of odometry that localization or Nav2 names, but no publisher of the workspace."""
    launches = all_launches(context)
    transforms = _odometry(context, programs_of(launches))
    published = {transform.parent for transform in transforms}
    if not published or may_have_other_publishers(context):
        return
    named: list[Value] = []
    paths = [file.path for launch in launches for file in launch.parameters]
    own = {file.path for file in context.launch.parameters}
    for node in nodes_in_files(paths, context.resolver):
        frame = scalar(node.values, _ODOMETRY_OF.get(node.name, ""))
        if frame and node.at.source.path in own:
            named.append(frame)
        elif node.name not in _ODOMETRY_OF:
            frames = (value for key, value in entries(node.values) if key in _ODOMETRY_KEYS)
            published.update(value.text.strip("/") for value in frames if isinstance(value, Value))
    for launch in launches:
        published.update(transform.child.name for transform in static_transforms(launch))
    unknown = [frame for frame in named if frame.text.strip("/") not in published]
    # The name of a topic, which programs name, too, is not a frame.
    names = {frame.text for frame in unknown if not _TOPIC.match(frame.text)}
    elsewhere = strings_in_programs(names, context.source.path, context.resolver)
    first = min(transforms, key=lambda transform: transform.parent)
    for frame in unknown:
        if frame.text and frame.text not in elsewhere and not re.search(r"[$<{]", frame.text):
            yield Finding(
                frame.span,
                f"the frame of odometry '{frame.text}' is not published; {first.publisher} "
                f"publishes '{first.parent}'",
                f"write {first.parent}",
            )


def _odometry(context: Context, programs: list[StartedProgram]) -> list[OdometryTransform]:
    """The transforms of odometry of filters; without a filter, those of wheel controllers.

    None if programs in namespaces, Gazebo or programs of the workspace may publish others.
    """
    if transforms := list(of_filters(programs, context)):
        return transforms
    if any(node.namespace != "" or node.executable in _SPAWNERS for node in programs):
        return []
    topics = (topic for node in programs for topic in bridged_topics(node, context.resolver))
    if any(topic.ros_topic.strip("/") == "tf" for topic in topics):
        return []
    return list(of_drives(programs, controllers_of_workspace(context)))


def _wrong_filter_frames(context: Context) -> Findings:
    """Invalid combinations of the frames of robot_localization."""
    paths = (file.path for file in context.launch.parameters)
    for node in nodes_in_files(paths, context.resolver):
        world, base = scalar(node.values, "world_frame"), scalar(node.values, "base_link_frame")
        others = [node.values.get(key) for key in ("odom_frame", "map_frame")]
        names = [frame.text for frame in others if isinstance(frame, Value)]
        if base is None or len(names) < len(others):
            continue
        odom = node.values["odom_frame"]
        if isinstance(odom, Value) and odom.text in (base.text, names[1]):
            key = "base_link_frame" if odom.text == base.text else "map_frame"
            yield Finding(
                odom.span,
                f"odom_frame and {key} are both '{odom.text}': robot_localization requires "
                "three different frames",
                "write odom_frame: odom, map_frame: map and the robot's link",
            )
        elif world and world.text not in names:
            yield Finding(
                world.span,
                f"world_frame '{world.text}' is neither odom_frame '{names[0]}' nor "
                f"map_frame '{names[1]}'",
                f"write {names[0]}, or {names[1]} for the filter that uses GPS",
            )
