"""The frames that a launch file and the robots of its workspace publish."""

import re
from collections.abc import Iterator
from itertools import chain

from urdfkit.checks.bringup.gz_bridges import may_bridge_transforms
from urdfkit.checks.bringup.workspace_launches import (
    distinct_descriptions,
    is_included,
    workspace_launches,
)
from urdfkit.lint.rules import Context
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import Launch
from urdfkit.ros.launch.transforms import StaticTransform, has_unknown_child, static_transform
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.install_rules import build_file
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.program_strings import may_publish
from urdfkit.workspace.ros_packages import comes_with_ros

#: Frames that programs other than those of the robot publish.
WELL_KNOWN = frozenset(("map", "odom", "world", "earth"))
#: Functions of Nav2 that change the frames in a parameter file.
_REWRITTEN = re.compile(rb"RewrittenYaml|ReplaceString|param_rewrites")
_PUBLISHER = "robot_state_publisher"
_RVIZ = ("rviz", "rviz2")
_SLIDERS = ("joint_state_publisher", "joint_state_publisher_gui")
#: Packages that do not localize the robot.
_VIEWERS = (_PUBLISHER, *_SLIDERS, *_RVIZ)
#: Packages that publish the frame of the map, and those that publish no other one above it.
_LOCALIZATION = ("nav2_amcl", "slam_toolbox")
_OF_NAVIGATION = re.compile(
    r"nav2_\w+|slam_toolbox|robot_localization|robot_state_publisher|rviz2|twist_mux|joy"
    r"|teleop_twist_(joy|keyboard)|tf2_ros|joint_state_publisher(_gui)?|controller_manager"
    r"|ros_gz_(sim|bridge|image)|moveit_ros_move_group"
)
#: A program in the build file of a package.
_PROGRAM = rb"(?i)\badd_(?:executable|library)\s*\(|console_scripts[\"']\s*:\s*\[\s*[\"']"
#: Words of a program that publishes transforms.
_TRANSFORMS = ("Transform", "TFMessage")
_WORLD, _NAMES_WORLD = "world", re.compile(rb":\s*[\"']?/?world\b")
#: Packages of ROS whose nodes publish other frames, of a sensor or a recording.
_PUBLISHERS_OF_ROS = ("mavros", "realsense2_camera", "rosbag", "rosbag2")


def published_frames(context: Context) -> frozenset[str]:
    """The published frames; empty if not all robots and static transforms are known."""
    launch = context.launch
    if any(map(has_unknown_child, launch.programs)):
        return frozenset()
    launches: tuple[Launch, ...] = (launch,)
    if not launch.descriptions:
        if _includes_unavailable(context) or _starts_publisher(launch):
            return frozenset()  # an included file may start another robot
        launches = workspace_launches(context)
        if _is_of_driver(context, launches):
            return frozenset()
    links = links_of_robots(context, launches)
    prefix = _prefix(launches)
    is_rewritten = bool(prefix) and _REWRITTEN.search(context.source.data)
    if not links or prefix is None or is_rewritten:
        return frozenset()
    links = frozenset(f"{prefix}{link}" for link in links)
    transforms = list(chain.from_iterable(map(static_transforms, launches)))
    children = {transform.child.name for transform in transforms}
    above = {transform.parent.name for transform in transforms if transform.child.name in links}
    is_viewer = _is_viewer(launch) and not is_included(context)
    well_known = frozenset() if is_viewer else WELL_KNOWN
    if _has_map_alone(context) and all(transform.parent.name != _WORLD for transform in transforms):
        well_known -= {_WORLD}
    return links.union(children, above, well_known)


def _is_of_driver(context: Context, launches: tuple[Launch, ...]) -> bool:
    """True for a launch file of a package with programs that knows none of the robots.

    A driver publishes frames of its own, which its examples show without a robot.
    """
    path, resolver = context.source.path, context.resolver
    package, manifest = resolver.packages.enclosing(path), manifest_of(resolver, path)
    if package is None or manifest is None:
        return False
    described = (description.path for launch in launches for description in launch.descriptions)
    robots = {found[0] for found in map(resolver.packages.enclosing, described) if found}
    if not robots.isdisjoint({package[0], *manifest.dependencies}):
        return False
    file = build_file(package[1])
    return bool(file) and re.search(_PROGRAM, read_head(file)) is not None


def _has_map_alone(context: Context) -> bool:
    """True if the root of all frames is that of localization: no node names another one."""
    programs = context.launch.programs
    path, resolver = context.source.path, context.resolver
    if any(
        may_publish(node.package, message, path, resolver)
        for node in programs
        if not _OF_NAVIGATION.fullmatch(node.package)
        for message in _TRANSFORMS
    ):
        return False
    sources = (context.resolver.readable(file.path) for file in context.launch.parameters)
    names_world = any(_NAMES_WORLD.search(source.data) for source in sources if source)
    is_localized = any(node.package in _LOCALIZATION for node in programs)
    is_bridged = may_bridge_transforms(programs, context.resolver)
    has_others = names_world or is_bridged or _includes_unavailable(context)
    return is_localized and not has_others


def links_of_robots(context: Context, launches: tuple[Launch, ...]) -> frozenset[str]:
    """Links of the robots that are started; empty if a robot cannot be expanded."""
    descriptions = distinct_descriptions(launches)
    robots = [robot for _, robot in context.expanded(descriptions)]
    if len(robots) < len(descriptions) or not all(one.is_whole for one in descriptions):
        return frozenset()
    if not all(robot.tree.has_base for robot in robots):  # an argument chooses the base
        return frozenset()
    return frozenset(name.lstrip("/") for robot in robots for name in robot.model.links_by_name)


def _prefix(launches: tuple[Launch, ...]) -> str | None:
    """What robot_state_publisher puts before the names of links; None if that is unknown."""
    # A launch file that describes the robot for MoveIt alone publishes no frames.
    publishing = [launch for launch in launches if _starts_publisher(launch)] or launches
    prefixes: set[str | None] = set()
    for launch in [launch for launch in publishing if not _is_viewer(launch)] or publishing:
        publishers = [node for node in launch.programs if node.package == _PUBLISHER]
        if launch.descriptions and not publishers:
            return None  # another program publishes the links
        for node in publishers:
            every = node.parameters.every
            prefix = None if every is None else every.get("frame_prefix", "")
            prefixes.add(prefix and prefix.lstrip("/"))  # tf2 strips the slash
    if not prefixes:
        return ""
    return prefixes.pop() if len(prefixes) == 1 else None


def _starts_publisher(launch: Launch) -> bool:
    return any(node.package == _PUBLISHER for node in launch.programs)


def _is_viewer(launch: Launch) -> bool:
    """True if the launch file starts only the publishers of a robot and RViz."""
    programs = launch.programs
    is_whole = not launch.unread and all(node.package in _VIEWERS for node in programs)
    packages = {node.package for node in programs}
    return is_whole and not packages.isdisjoint(_RVIZ) and not packages.isdisjoint(_SLIDERS)


def static_transforms(launch: Launch) -> Iterator[StaticTransform]:
    for node in launch.programs:
        if transform := static_transform(node):
            yield transform


def may_have_other_publishers(context: Context) -> bool:
    """True if unavailable nodes, such as drivers or a bag player, may publish frames."""
    programs = context.launch.programs
    if any(_is_unavailable(context, node.package) for node in programs if node.package):
        return True
    if any("bag" in (word.text for word in node.words) for node in programs if not node.package):
        return True
    return _includes_unavailable(context)


def _includes_unavailable(context: Context) -> bool:
    """True if the launch file includes files of unavailable packages that are not part of ROS."""
    paths = (path.removeprefix(UNKNOWN).strip("/") for path in context.launch.unread)
    return any(_is_unavailable(context, path.partition("/")[0]) for path in paths if path)


def _is_unavailable(context: Context, package: str) -> bool:
    if package in _PUBLISHERS_OF_ROS:
        return True  # even if the package is in the workspace: it computes its frame names
    if comes_with_ros(package):
        return False
    packages = context.resolver.packages
    return not any(True for _ in packages.candidates(package, context.source.path))
