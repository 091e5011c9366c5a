"""Settings of Gazebo's resource path, for meshes, in a workspace.

Gazebo interprets ``package://arm/...`` as ``model://arm/...`` and searches its resource path, which
does not contain ROS packages. The path must be set: by a package.xml that exports
``gazebo_model_path``, a launch file or an environment hook that sets the variable, or the shell.
A launch file that replaces ``package://`` by a path does not need it.
Source: sdformat's parser_urdf.cc, gazebo_ros_paths.py of gazebo_ros and of ros_gz_sim.
"""

from __future__ import annotations

import os
import re

from urdfkit.core.record import Record
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head

#: Bounds of the search.
MAX_DIRECTORIES, MAX_FILES, MAX_BYTES = 500, 1000, 65_536

_STARTERS = (b"ros_gz_sim", b"ros_ign_gazebo", b"gazebo_ros", b"gz_sim.launch", b"spawn_entity")
#: The variable of Fortress and before.
FORMER = (b"IGN_GAZEBO_RESOURCE_PATH",)
_VARIABLES = (
    b"gazebo_model_path",
    b"GAZEBO_MODEL_PATH",
    b"GZ_SIM_RESOURCE_PATH",
    b"IGN_GAZEBO_RESOURCE_PATH",
    b"SDF_PATH",
)
#: Calls in Python or a shell that replace the scheme of meshes, or make their paths absolute.
_REPLACES = rb"""\b(?:replace|sub)\(\s*\w?["']package:|\bsed\b[^\n]{0,200}package:"""
#: Suffixes of files that can set the path: shell and build files, hooks, instructions.
_TEXTS = (
    ".launch", ".py", ".xml", ".yaml", ".yml", ".sh", ".bash", ".zsh", ".dsv", ".in", ".env",
    ".md", ".rst", ".txt", "Dockerfile", "Makefile",
)  # fmt: skip


class ResourcePaths(Record):
    """Findings in the files of a workspace."""

    starter: str | None  # a launch file that starts Gazebo; None if there is none
    mentions: tuple[str, ...]  # the files that mention Gazebo's resource path
    replaces: bool  # True if a file replaces ``package://``
    is_whole: bool  # False if there were too many files

    @property
    def is_mentioned(self) -> bool:
        """True if the path may be set, or need not be."""
        return bool(self.mentions) or self.replaces or not self.is_whole


def survey(root: str, directories: Directories, former: tuple[bytes, ...] = ()) -> ResourcePaths:
    """Search the text files of a workspace, within bounds.

    Args:
        former: variables that this Gazebo does not read.
    """
    files = [
        path for path in directories.files_below(root, MAX_DIRECTORIES) if path.endswith(_TEXTS)
    ]
    starter = None
    replaces = False
    mentions: list[str] = []
    variables = [word for word in _VARIABLES if word not in former]
    for path in files[:MAX_FILES]:
        data = read_head(path, MAX_BYTES)
        if any(word in data for word in variables):
            mentions.append(path)
        replaces = replaces or bool(re.search(_REPLACES, data))
        is_starter = any(word in data for word in _STARTERS) and b"$(find " not in data  # ROS 1
        if starter is None and _is_launch(path) and is_starter:
            starter = path
    return ResourcePaths(starter, tuple(mentions), replaces, len(files) <= MAX_FILES)


def _is_launch(path: str) -> bool:
    name = os.path.basename(path)
    return name.endswith((".launch", ".launch.xml", ".launch.py")) or "_launch." in name
