"""A parameter file, RViz or a static transform names a frame that nothing publishes.

tf has the links of the robot, which robot_state_publisher publishes, the children of static
transforms, and `map`, `odom` and `world`, which localization and odometry publish. With any other
name robot_localization, Nav2 and slam_toolbox wait for ever: "Could not find a connection between
'odom' and 'base'", "Timed out waiting for transform from base to map". RViz shows nothing: "Fixed
Frame [base] does not exist". A static transform with such a parent makes a second tree.

Checked are `base_link_frame`, `base_link_output_frame`, `robot_base_frame`, `base_frame`,
`base_frame_id` and `sensor_frame`, RViz's fixed frame and the frames of its displays, and the
parents of static transforms, unless the launch file starts drivers that are not in the workspace,
which publish frames of their own. The robot is that of the launch file, else those that the other
launch files of the workspace start. A frame that a program of the workspace names is left out. So
is the `global_frame` of a costmap, the frame of a map or of odometry, unless it is a typo of `map`
or `odom`. `map`, `odom` and `world` as the fixed frame are reported where a launch file starts RViz
with joint_state_publisher and nothing else. So is a `world_frame` of robot_localization that is
neither its `odom_frame` nor its `map_frame`, at which the filter stops, and an `odom_frame` that is
one of the others ("Invalid frame configuration!").

Sources:
    REP 105, coordinate frames: https://www.ros.org/reps/rep-0105.html
    robot_localization, parameters: https://github.com/cra-ros-pkg/robot_localization/blob/ros2/params/ekf.yaml
    Nav2, costmap: https://docs.nav2.org/configuration/packages/configuring-costmaps.html
    RViz, frame_manager.cpp: https://github.com/ros2/rviz/blob/rolling/rviz_common/src/rviz_common/frame_manager.cpp
"""

from collections.abc import Iterator

from urdfkit.core.suggest import did_you_mean, nearest
from urdfkit.core.words import few
from urdfkit.lint.rules import Context, Finding, Findings, Location, Need, Related, Severity, rule
from urdfkit.ros.launch.argument_checks import is_included
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import Launch, StartedProgram
from urdfkit.ros.launch.frames import GLOBAL, NamedFrame, named_frames
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.ros.launch.transforms import StaticTransform, static_transform
from urdfkit.text.located_yaml import Node, Value, load, mapping
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

_WELL_KNOWN = frozenset(("map", "odom", "world", "earth"))
#: What a costmap may be in, and the similarity of a typo.
_GLOBAL = ("map", "odom")
_TYPO = 0.6
_PUBLISHER = "robot_state_publisher"
_RVIZ = ("rviz", "rviz2")
_SLIDERS = ("joint_state_publisher", "joint_state_publisher_gui")
#: What starts nothing that localizes the robot.
_VIEWERS = (_PUBLISHER, *_SLIDERS, *_RVIZ)
#: Packages of ROS whose nodes publish frames of their own: of a sensor, or what was recorded.
_PUBLISHERS_OF_ROS = ("mavros", "realsense2_camera", "rosbag", "rosbag2")
#: Robots of a workspace that are expanded, to know their links.
_MAX_ROBOTS = 8
_NAMED = 4


@rule(Severity.WARNING, needs=(Need.LAUNCH,))
def check(context: Context) -> Findings:
    launch = context.launch
    named = list(named_frames(launch, context.resolver))
    if not named and not any(True for _ in _transforms(launch)):
        return
    known = _published(context)
    if known:
        known |= _of_filters(launch, named)
        given = {key for one in _started(launch) for key in one.parameters.values}
        last_words = {name.rpartition("/")[2] for name in known}
        of_others = _of_drivers(launch)
        unknown = [
            one
            for one in named
            if one.name not in known
            and one.key not in given
            and (one.key or one.name not in of_others)
            and not _is_in_namespace(one, launch, last_words)
            and (one.key != GLOBAL or _is_typo(one, named))
        ]
        parents = {}
        if not _has_foreign_publishers(context):
            parents = dict(_unknown_parents(launch, known, _of_robots(context, (launch,))))
        words = {one.name for one in unknown} | parents.keys()
        elsewhere = strings_in_programs(words, context.source.path, context.resolver)
        yield from (_unknown(one, known) for one in unknown if one.name not in elsewhere)
        yield from (found for name, found in parents.items() if name not in elsewhere)
    yield from _other_world(context)


def _is_in_namespace(frame: NamedFrame, launch: Launch, last_words: set[str]) -> bool:
    """True for a frame that a robot may publish if another launch file starts it in a namespace."""
    _, namespace, last = frame.name.rpartition("/")
    if frame.key:
        return bool(namespace and not launch.descriptions)
    return bool(namespace and last in last_words)


def _is_typo(frame: NamedFrame, named: list[NamedFrame]) -> bool:
    """True for a frame that no other one is called like, and that is like that of a map."""
    uses = [one.name for one in named].count(frame.name)
    return uses == 1 and nearest(frame.name, _GLOBAL, _TYPO) is not None


def _of_drivers(launch: Launch) -> frozenset[str]:
    """The frames with which nodes stamp their messages, by their parameters; RViz shows these."""
    return frozenset(
        value.lstrip("/")
        for one in _started(launch)
        for key, value in one.parameters.values.items()
        if value and "frame" in key
    )


def _has_foreign_publishers(context: Context) -> bool:
    """True if nodes that are not at hand may publish frames: drivers, or what a bag plays back."""
    started = _started(context.launch)
    if any(_is_foreign(context, one.package) for one in started if one.package):
        return True
    if any("bag" in (word.text for word in one.words) for one in started if not one.package):
        return True
    return _includes_foreign(context)


def _includes_foreign(context: Context) -> bool:
    """True if it includes launch files of packages that are not at hand and not of ROS itself."""
    packages = (path.removeprefix(UNKNOWN) for path in context.launch.unread)
    return any(_is_foreign(context, path.strip("/").partition("/")[0]) for path in packages if path)


def _is_foreign(context: Context, package: str) -> bool:
    if package in _PUBLISHERS_OF_ROS:
        return True  # a copy in the workspace, too: it computes the names of its frames
    if comes_with_ros(package):
        return False
    packages = context.resolver.packages
    return not any(True for _ in packages.candidates(package, context.source.path))


def _of_filters(launch: Launch, named: list[NamedFrame]) -> frozenset[str]:
    """The frames that a filter publishes beside the robot, for the static transforms on them."""
    parents = {(one.parent.text or "").lstrip("/") for one in _transforms(launch)}
    return frozenset(one.name for one in named if one.key == "base_link_frame") & parents


def _unknown(frame: NamedFrame, known: frozenset[str]) -> Finding:
    published = sorted(_GLOBAL if frame.key == GLOBAL else known - _WELL_KNOWN)
    return Finding(
        Location(frame.span),
        f"{frame.who} '{frame.name}' is no link of the robot and no static transform"
        f"{did_you_mean(frame.name, published)}",
        f"name a frame that is published: {few(published, _NAMED)}",
        related=(Related(frame.named_at, "the file is named here"),),
    )


def _published(context: Context) -> frozenset[str]:
    """The frames that are known to be published; none if not all of the robots are known."""
    launch = context.launch
    links = _of_robots(context, (launch,))
    launches: tuple[Launch, ...] = (launch,)
    if not launch.descriptions and (_includes_foreign(context) or _publishes(launch)):
        return frozenset()  # one of these may start another robot
    if not launch.descriptions:
        launches = launches_of_workspace(context.source.path, context.resolver)
        links = _of_robots(context, launches)
    if not links or any(map(_renames_frames, launches)):
        return frozenset()
    transforms = [transform for one in launches for transform in _transforms(one)]
    children = [(transform.child.text or "").lstrip("/") for transform in transforms]
    parents = [(transform.parent.text or "").lstrip("/") for transform in transforms]
    above = (parent for parent, child in zip(parents, children, strict=True) if child in links)
    is_viewer = _is_viewer(launch) and not is_included(context.source.path, context.resolver)
    well_known = frozenset() if is_viewer else _WELL_KNOWN
    return links.union(children, above, well_known)


def _of_robots(context: Context, launches: tuple[Launch, ...]) -> frozenset[str]:
    """The links of the robots that are started; none if one of them cannot be expanded."""
    found: set[str] = set()
    descriptions = [one for launch in launches for one in launch.descriptions]
    distinct = {(one.path, *sorted(one.arguments.items())): one for one in descriptions}
    if len(distinct) > _MAX_ROBOTS:
        return frozenset()
    for description in distinct.values():
        robot = context.other_robot(description.path, description.arguments)
        if robot.reading.document is None or not description.is_whole:
            return frozenset()
        found.update(name.lstrip("/") for name in robot.model.links_by_name)
    return frozenset(found)


def _renames_frames(launch: Launch) -> bool:
    """True if links may be published under other names, or nothing of ROS publishes them."""
    started = _started(launch)
    publishers = [one for one in started if one.package == _PUBLISHER]
    renaming = (
        "frame_prefix" in one.parameters.values or one.parameters.every is None
        for one in publishers
    )
    return any(renaming) or (bool(launch.descriptions) and not publishers)


def _publishes(launch: Launch) -> bool:
    """True if it starts robot_state_publisher."""
    return any(one.package == _PUBLISHER for one in _started(launch))


def _is_viewer(launch: Launch) -> bool:
    """True if it starts the publishers of a robot and RViz, and nothing else."""
    started = _started(launch)
    is_whole = not launch.unread and all(one.package in _VIEWERS for one in started)
    packages = {one.package for one in started}
    return is_whole and not packages.isdisjoint(_RVIZ) and not packages.isdisjoint(_SLIDERS)


def _started(launch: Launch) -> tuple[StartedProgram, ...]:
    return (*launch.started, *launch.included)


def _transforms(launch: Launch) -> Iterator[StaticTransform]:
    for one in _started(launch):
        if found := static_transform(one):
            yield found


def _unknown_parents(
    launch: Launch, known: frozenset[str], of_robot: frozenset[str]
) -> Iterator[tuple[str, Finding]]:
    """The parents that make a second tree; a parent of the robot's root is one above it."""
    for one in launch.started:
        found = static_transform(one)
        if found is None:
            continue
        name, child = ((word.text or "").lstrip("/") for word in (found.parent, found.child))
        # Gazebo's plugins publish frames as MODEL/FRAME.
        if name and name.rpartition("/")[2] not in known and child not in of_robot:
            yield (
                name,
                Finding(
                    Location(found.parent.span, one.frame),
                    f"parent '{name}' of the static transform is no link of the robot"
                    f"{did_you_mean(name, known)}",
                    f"name a frame that is published: {few(sorted(known - _WELL_KNOWN), _NAMED)}",
                ),
            )


def _other_world(context: Context) -> Findings:
    """A world frame of robot_localization that is neither of its two."""
    for file in context.launch.parameters:
        source = context.resolver.readable(file.path)
        for section in _sections(load(source)) if source else ():
            world, base = section.get("world_frame"), section.get("base_link_frame")
            others = [section.get(key) for key in ("odom_frame", "map_frame")]
            names = [one.text for one in others if isinstance(one, Value)]
            if not isinstance(base, Value) or len(names) < len(others):
                continue
            odom = section["odom_frame"]
            if isinstance(odom, Value) and odom.text in (base.text, names[1]):
                key = "base_link_frame" if odom.text == base.text else "map_frame"
                yield Finding(
                    Location(odom.span),
                    f"odom_frame and {key} are both '{odom.text}': robot_localization asks for "
                    "three different frames",
                    "write odom_frame: odom, map_frame: map and the robot's link",
                )
            elif isinstance(world, Value) and world.text not in names:
                yield Finding(
                    Location(world.span),
                    f"world_frame '{world.text}' is neither odom_frame '{names[0]}' nor "
                    f"map_frame '{names[1]}'",
                    f"write {names[0]}, or {names[1]} for the filter that takes in GPS",
                )


def _sections(root: Node) -> Iterator[dict[str, Node]]:
    """The parameters of each node."""
    for node in mapping(root).values():
        if inside := mapping(node, "ros__parameters"):
            yield inside
