"""Search for ROS packages, without ROS."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.memo import LIMIT, Memo
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.package_directories import PackageDirectories, read_marker
from urdfkit.workspace.search_root import Root, ScannedDirectory, SearchRoots

if TYPE_CHECKING:
    from urdfkit.workspace.package_scan import PackageScan

#: Depth of a scan inside a repository or workspace, and outside of it.
DEPTH_INSIDE = 12
DEPTH_OUTSIDE = 4

_MODEL_PATH = rb"""\bgazebo_model_path\s*=\s*(?:"([^"]*)"|'([^']*)')"""


class Candidate(Record):
    """A directory that may be a package."""

    directory: str
    certain: bool = True  # False if only the name matches, without a ``package.xml``
    trusted: bool = False  # True if the environment of the user refers to it


class Packages:
    """Finds packages; results are cached.

    Args:
        explicit: directories by package name, which override every search.
        environment: defines ``AMENT_PREFIX_PATH`` and ``ROS_PACKAGE_PATH``.
    """

    def __init__(
        self, explicit: Mapping[str, str], environment: Mapping[str, str], directories: Directories
    ) -> None:
        self.explicit = {name: os.path.abspath(directory) for name, directory in explicit.items()}
        self._packages = PackageDirectories(directories)
        self._roots = SearchRoots(self._packages, environment)
        self.prefixes = path_list(environment, "AMENT_PREFIX_PATH")
        self.ros1_paths = path_list(environment, "ROS_PACKAGE_PATH")
        self._scan: Callable[[ScannedDirectory], PackageScan] = lru_cache(LIMIT)(self._new_scan)
        self._searched: Memo[str, tuple[str, ...]] = Memo()
        #: The packages by the directory of a file: each program of a launch file is looked up.
        self._known: Callable[[str], dict[str, str]] = lru_cache(LIMIT)(self._find_known)
        #: The absolute directory of a file; cached, as a robot may refer to a hundred meshes.
        self.directory_of: Callable[[str], str] = lru_cache(LIMIT)(_directory_of)

    def candidates(self, name: str, near: str) -> Iterator[Candidate]:
        """The directories that may be a package; certain candidates in order of preference.

        Args:
            near: path of the file that refers to the package.
        """
        if name in self.explicit:
            if disk.is_directory(self.explicit[name]):
                yield Candidate(self.explicit[name])
            return
        if name in ("", ".", "..") or "/" in name or "\\" in name:
            return  # a path, which could leave AMENT_PREFIX_PATH
        around = dict(self._roots.enclosing_packages(self.directory_of(near)))
        if name in around:  # of several, the outermost: builds do not look inside a package
            yield Candidate(around[name])
        for directory in self._in_environment(name):
            yield Candidate(directory, trusted=True)
        # A build may install this directory under its name, even if a package.xml is elsewhere.
        yield from (Candidate(at, certain=False) for at in self._parents_named(name, near))
        for level in self.levels(near):
            if package_directory := self._scan(level).find(name):
                yield Candidate(package_directory)
        for directory in self.siblings_named(name, near):
            yield Candidate(directory, certain=False)

    def searched(self, name: str, near: str) -> tuple[str, ...]:
        """The locations that ``candidates`` searches, for a message."""
        if name in self.explicit:
            return (f"{self.explicit[name]} (given for {name}; no such directory)",)
        start = self.directory_of(near)
        if start not in self._searched:  # a robot may refer to a missing package a hundred times
            self._searched[start] = (
                f"{start} and its parent directories",
                f"AMENT_PREFIX_PATH ({os.pathsep.join(self.prefixes) or 'not set'})",
                f"ROS_PACKAGE_PATH ({os.pathsep.join(self.ros1_paths) or 'not set'})",
                *(self._scan(level).summary() for level in self.levels(near)),
            )
        return self._searched[start]

    def known(self, near: str) -> dict[str, str]:
        """The directories of the packages in the workspace of a file, by name; nearest first.

        Of packages around the file with the same name, the outermost. Shared, not to be changed.
        """
        return self._known(self.directory_of(near))

    def _find_known(self, start: str) -> dict[str, str]:
        packages = dict(self._roots.enclosing_packages(start))
        for level in self._roots.levels(start):
            for name, directory in self._scan(level).all().items():
                packages.setdefault(name, directory)
        return packages

    def enclosing(self, path: str) -> tuple[str, str] | None:
        """Name and directory of the package that contains a file."""
        return self._roots.enclosing(self.directory_of(path))

    def workspace(self, near: str) -> str:
        """The repository or workspace of a file, otherwise its package, otherwise its directory."""
        return self.root(near).directory

    def root(self, near: str) -> Root:
        """The root of the search for packages that a file refers to."""
        return self._roots.root(self.directory_of(near))

    def searches(self, directory: str, near: str) -> bool:
        """True if a directory is searched for packages that a file refers to."""
        return any(is_within(directory, level.root) for level in self.levels(near))

    def levels(self, near: str) -> tuple[ScannedDirectory, ...]:
        """The directories that are scanned for packages that a file refers to, innermost first."""
        return self._roots.levels(self.directory_of(near))

    def gazebo_model_paths(self, near: str) -> Iterator[tuple[str, str]]:
        """Paths that packages export as ``gazebo_model_path``: package directory and relative path.

        gazebo_ros adds them to Gazebo's model path.
        """
        for directory in self.known(near).values():
            for match in re.finditer(_MODEL_PATH, read_marker(directory, "package.xml")):
                text = (match.group(1) or match.group(2) or b"").decode("utf-8", "replace")
                for path in text.split(":"):
                    prefix, prefixed, relative = path.partition("${prefix}")
                    if prefixed and not prefix:
                        yield directory, relative

    def is_shared(self, directory: str) -> bool:
        """True for home, /tmp and others, which contain files of more than one project."""
        return directory in self._roots.shared

    def name_of(self, directory: str) -> str | None:
        """Name of the package in a directory; None if it is not a package."""
        return self._packages.name_of(directory)

    def siblings_named(self, name: str, near: str) -> Iterator[str]:
        """Directories of a name next to the parent directories of a file, innermost first."""
        parents = [at for at in upwards(self.directory_of(near)) if self.searches(at, near)]
        for directory in parents:
            sibling = os.path.join(directory, name)
            if sibling not in parents and disk.is_directory(sibling):
                yield sibling

    def _new_scan(self, level: ScannedDirectory) -> PackageScan:
        from urdfkit.workspace.package_scan import PackageScan  # often the robot's package suffices

        depth = DEPTH_INSIDE if level.inside else DEPTH_OUTSIDE
        return PackageScan(self._packages, level.root, depth, nested=level.inside)

    def _in_environment(self, name: str) -> Iterator[str]:
        for prefix in self.prefixes:
            directory = os.path.join(prefix, "share", name)
            if disk.is_directory(directory):
                yield directory
        for path in self.ros1_paths:
            if self.name_of(path) == name:
                yield path
            direct = os.path.join(path, name)
            if self.name_of(direct) == name:
                yield direct
            if scanned := self._scan(ScannedDirectory(path, False)).find(name):
                yield scanned

    def _parents_named(self, name: str, near: str) -> list[str]:
        """The parent directories of a file with a name, in its workspace; innermost first."""
        return [
            directory
            for directory in upwards(self.directory_of(near))
            if name
            and os.path.basename(directory) == name
            and directory not in self._roots.shared
            and (not self.root(near).mark or self.searches(directory, near))
        ]


def _directory_of(path: str) -> str:
    return os.path.dirname(os.path.abspath(path))


def path_list(environment: Mapping[str, str], variable: str) -> list[str]:
    """The directories in a variable such as ``AMENT_PREFIX_PATH``."""
    parts = environment.get(variable, "").split(os.pathsep)
    return [os.path.abspath(part) for part in parts if part]
