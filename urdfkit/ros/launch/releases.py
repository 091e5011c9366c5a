"""The release of ROS 2 that the parameter files of a workspace are written for."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import lru_cache

from urdfkit.ros.launch.robot_arguments import launches_below
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

#: The packages of Nav2 whose classes have a slash up to Iron, and colons later.
_PACKAGES = rb"\bnav2_(behaviors|navfn_planner|smac_planner|theta_star_planner)"
#: What only Jazzy and later have: stamped commands of Nav2 and twist_mux, lists of MoveIt, names
#: of classes.
_JAZZY = re.compile(
    rb"^[^#\n]*(\b(enable_stamped_cmd_vel|use_stamped|planning_plugins|response_adapters)\s*:"
    rb"|\bparallel_gripper_action_controller/"
    rb"|" + _PACKAGES + rb"::)",
    re.MULTILINE,
)
_OLDER = re.compile(rb"^[^#\n]*" + _PACKAGES + rb"/", re.MULTILINE)
_INSTALLED = re.compile(rb"/opt/ros/(?:foxy|galactic|humble)/")


def is_for_jazzy(path: str, resolver: Resolver, others: Iterable[str] = ()) -> bool:
    """True if parameter files of the workspace of a file have only names of Jazzy and later.

    Args:
        others: paths of further parameter files.
    """
    workspace = resolver.packages.workspace(path)
    return _is_loaded_for_jazzy(workspace, resolver) or _have_later_names(others, resolver)


@lru_cache(maxsize=2)  # the launch files of a workspace are queried one after the other
def _is_loaded_for_jazzy(workspace: str, resolver: Resolver) -> bool:
    launches = launches_below(workspace, resolver)
    paths = {file.path for launch in launches for file in launch.parameters if file.exists}
    return _have_later_names(sorted(paths), resolver)


def _have_later_names(paths: Iterable[str], resolver: Resolver) -> bool:
    sources = filter(None, map(resolver.readable, paths))
    return any(_JAZZY.search(file.data) and not _OLDER.search(file.data) for file in sources)


def is_of_older(source: Source) -> bool:
    """True if a parameter file has names of Iron and earlier, or paths of Humble and earlier."""
    return bool(_OLDER.search(source.data) or _INSTALLED.search(source.data))
