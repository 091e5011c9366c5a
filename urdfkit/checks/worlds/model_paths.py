"""Gazebo's resource path, as the launch files and packages of a workspace set it."""

from __future__ import annotations

import os
from collections import Counter

from urdfkit.core import disk
from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.lint.rules import Context
from urdfkit.ros.gazebo.paths import survey
from urdfkit.ros.launch.contents import EnvironmentSetting
from urdfkit.ros.launch.releases import is_for_jazzy
from urdfkit.ros.launch.robot_arguments import launches_of_workspace
from urdfkit.text.source import Span
from urdfkit.workspace.file_head import read_head

VARIABLE = "GZ_SIM_RESOURCE_PATH"
#: The variable of Fortress and before, from which Harmonic takes only worlds.
FORMER = "IGN_GAZEBO_RESOURCE_PATH"
#: Also read by gz sim.
_OTHERS = ("SDF_PATH", "GZ_FILE_PATH")
_WORDS = tuple(name.encode() for name in (VARIABLE, FORMER, *_OTHERS, "gazebo_model_path"))
_WITHOUT_FORMER = ("gz-harmonic", "gz-jetty")


class ResourcePath(Record):
    """The directories in which gz sim looks for models."""

    directories: frozenset[str]
    former: dict[str, Span]  # directories of a variable that this gz sim does not read

    def contains(self, model: str) -> bool:
        """True if the directory of a model is found."""
        return os.path.dirname(model) in self.directories


def resource_path(context: Context) -> ResourcePath | None:
    """The resource path of the workspace; None if files or values that are not known set it."""
    packages, near = context.resolver.packages, context.source.path
    root = packages.workspace(near)
    every = _settings(context)
    seen = survey(root, context.resolver.directories)
    counts = Counter(os.path.abspath(one.word.span.source.path) for one in every)
    exports = list(packages.gazebo_model_paths(near))
    if not seen.is_whole or any(
        _count(path) > counts[os.path.abspath(path)]
        for path in seen.mentions
        if not (exports and path.endswith("package.xml"))
    ):
        return None
    found = {os.path.normpath(directory + relative) for directory, relative in exports}
    former: dict[str, Span] = {}
    is_without_former = _is_without_former(context)
    for setting in every:
        directories = _directories(setting, root)
        if directories is None:
            return None
        if setting.name == FORMER and is_without_former:
            former |= dict.fromkeys(directories, setting.word.span)
        else:
            found |= directories
    return ResourcePath(frozenset(found), former)


def _settings(context: Context) -> list[EnvironmentSetting]:
    """What the launch files of the workspace set, each once."""
    launches = launches_of_workspace(context.source.path, context.resolver)
    every = {
        (setting.word.span.source.path, setting.word.span.start): setting
        for launch in launches
        for setting in launch.environment
    }
    return [one for one in every.values() if one.name in (VARIABLE, FORMER, *_OTHERS)]


def _directories(setting: EnvironmentSetting, root: str) -> set[str] | None:
    """The directories of a value; None if one is known at run time only, or made by a build."""
    if setting.word.text is None:
        return None
    paths = {os.path.normpath(part) for part in setting.word.text.split(":") if part}
    is_built = any(is_within(path, root) and not disk.is_directory(path) for path in paths)
    return None if is_built else paths


def _count(path: str) -> int:
    """How often a file mentions a variable."""
    text = read_head(path)
    return sum(map(text.count, _WORDS))


def _is_without_former(context: Context) -> bool:
    """True if the workspace is for a gz sim that does not read the former variable."""
    robots = (robot for _, robot in context.described_robots)
    is_later = any(robot.targets.any_of(_WITHOUT_FORMER) for robot in robots)
    return is_later or is_for_jazzy(context.source.path, context.resolver)
