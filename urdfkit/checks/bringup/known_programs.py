"""Launch files of which all programs are known."""

import re
from collections.abc import Iterable

from urdfkit.checks.bringup.unread_commands import is_part_of_ros
from urdfkit.lint.rules import Context
from urdfkit.ros.catalog import data
from urdfkit.ros.launch.collect import UNKNOWN
from urdfkit.ros.launch.contents import MAP, POSE_GRAPH, RVIZ, Launch, StartedProgram
from urdfkit.workspace.program_strings import may_contain
from urdfkit.workspace.ros_packages import comes_with_ros

#: Programs that publish neither a robot nor the time, and need nobody: whether they run is the
#: same to the others.
_OPTIONAL = frozenset(
    (
        "rviz2/rviz2",
        "joint_state_publisher/joint_state_publisher",
        "joint_state_publisher_gui/joint_state_publisher_gui",
        "controller_manager/spawner",
    )
)
#: What programs publish or start that others wait for.
_AWAITED = (
    "robot_description", "JointState", "Transform", "Clock", "ControllerManager",
    "ros2_control_node",
)  # fmt: skip
#: Packages whose programs publish no joint states.
_NAVIGATION = re.compile(r"nav2_\w+|slam_toolbox|robot_localization|moveit_ros_move_group")
#: Files that change no topic; maps are often not committed.
_SILENT = (MAP, POSE_GRAPH, RVIZ)


def known_programs(context: Context) -> tuple[StartedProgram, ...]:
    """The programs of a launch file; none if not all of them are known.

    Optional ones have a condition that is known only at run time.
    """
    programs = context.launch.programs
    return programs if _is_whole(context.launch) and _are_sure(programs, context) else ()


def programs_of_robot(context: Context) -> tuple[StartedProgram, ...]:
    """The same, though localization or planning may depend on a condition."""
    programs = context.launch.programs
    others = (node for node in programs if not _NAVIGATION.fullmatch(node.package))
    return programs if _is_whole(context.launch) and _are_sure(others, context) else ()


def running_programs(context: Context) -> tuple[StartedProgram, ...]:
    """The programs that certainly run, of a launch file that names nothing unknown."""
    programs = context.launch.programs
    return tuple(node for node in programs if node.is_sure) if _is_whole(context.launch) else ()


def are_topics_known(context: Context) -> bool:
    """True if a launch file starts known programs in known namespaces, and nothing else.

    Some of them may depend on a condition.
    """
    launch = context.launch
    is_whole = not launch.has_scopes and all(map(is_part_of_ros, launch.unread))
    return is_whole and _is_whole(launch)


def _are_sure(programs: Iterable[StartedProgram], context: Context) -> bool:
    """True if all programs certainly run, are optional, or run in another process.

    Optional are also programs of the workspace whose sources name nothing that others wait for. The
    last are those of Nav2's use_composition.
    """
    programs = list(programs)
    running = {(node.package, node.executable) for node in programs if node.is_sure}
    return all(
        node.is_sure
        or node.key in _OPTIONAL
        or (node.package.startswith("nav2_") and (node.package, node.executable) in running)
        or _is_aside(node, context)
        for node in programs
    )


def _is_aside(program: StartedProgram, context: Context) -> bool:
    """True for a program of the workspace that publishes nothing of `_AWAITED`."""
    near, resolver = context.source.path, context.resolver
    return bool(program.package) and not any(
        may_contain(program.package, word, near, resolver) for word in _AWAITED
    )


def _is_whole(launch: Launch) -> bool:
    """True if all referenced packages and files exist, or are part of ROS."""
    known = {name.partition("/")[0] for name in data("nodes")["publishers"]}
    packages = (
        item.searched is None or comes_with_ros(item.name) or item.name in known
        for item in launch.packages
    )
    files = (
        item.exists or item.purpose in _SILENT or item.path.startswith(f"{UNKNOWN}/")
        for item in launch.files
    )
    return all(packages) and all(files)
