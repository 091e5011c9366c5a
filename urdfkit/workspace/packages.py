"""Finding ROS packages without ROS."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfkit.core import disk
from urdfkit.core.memo import Memo
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.record import Record
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.package_directories import PackageDirectories, read_marker
from urdfkit.workspace.search_root import Root, ScannedDirectory, SearchRoots

if TYPE_CHECKING:
    from urdfkit.workspace.package_scan import PackageScan

#: Depth of a scan inside a repository or workspace, and of one outside of it.
DEPTH_INSIDE = 12
DEPTH_OUTSIDE = 4

_MODEL_PATH = rb"""\bgazebo_model_path\s*=\s*(?:"([^"]*)"|'([^']*)')"""


class Candidate(Record):
    """A directory that may be the package of a name."""

    directory: str  # the package's directory
    certain: bool = True  # False if it only has the name of the package, without a ``package.xml``
    trusted: bool = False  # True if the environment of the user names it


class Packages:
    """Finds packages; everything is read once.

    Args:
        explicit: directories by package name, which win over every search.
        environment: ``AMENT_PREFIX_PATH`` and ``ROS_PACKAGE_PATH`` are read from it.
    """

    def __init__(
        self, explicit: Mapping[str, str], environment: Mapping[str, str], directories: Directories
    ) -> None:
        self.explicit = {name: os.path.abspath(directory) for name, directory in explicit.items()}
        self.directories = directories
        self._packages = PackageDirectories(directories)
        self._roots = SearchRoots(self._packages, environment)
        self.prefixes = path_list(environment, "AMENT_PREFIX_PATH")
        self.ros1_paths = path_list(environment, "ROS_PACKAGE_PATH")
        self._scans: Memo[ScannedDirectory, PackageScan] = Memo()
        self._searched: Memo[str, tuple[str, ...]] = Memo()
        self._directories_of: Memo[str, str] = Memo()

    def directory_of(self, path: str) -> str:
        """The absolute directory of a file; worked out once, as a robot names a hundred meshes."""
        if path not in self._directories_of:
            self._directories_of[path] = os.path.dirname(os.path.abspath(path))
        return self._directories_of[path]

    def candidates(self, name: str, near: str) -> Iterator[Candidate]:
        """The directories that may be a package, the best first of those that are certain.

        Args:
            near: path of the file that refers to it.
        """
        if name in self.explicit:
            if disk.is_directory(self.explicit[name]):
                yield Candidate(self.explicit[name])
            return
        if name in ("", ".", "..") or "/" in name or "\\" in name:
            return  # a path; below AMENT_PREFIX_PATH it would lead to any directory
        start = self.directory_of(near)
        yield from (Candidate(at) for own, at in self._roots.around(start) if own == name)
        for directory in self._in_environment(name):
            yield Candidate(directory, trusted=True)
        # A build may install this directory under its name, whatever package.xml lies elsewhere.
        yield from (Candidate(at, certain=False) for at in self._named(name, near))
        for level in self.levels(near):
            found = self._scan(level).find(name)
            if found:
                yield Candidate(found)
        for directory in self.siblings_named(name, near):
            yield Candidate(directory, certain=False)

    def searched(self, name: str, near: str) -> tuple[str, ...]:
        """Where ``candidates`` looks, in words a user can check."""
        if name in self.explicit:
            return (f"{self.explicit[name]} (given for {name}; no such directory)",)
        start = self.directory_of(near)
        if start not in self._searched:  # a robot may name a missing package a hundred times
            self._searched[start] = self._search_of(start, near)
        return self._searched[start]

    def _search_of(self, start: str, near: str) -> tuple[str, ...]:
        reported = [f"{start} and its parent directories"]
        for variable, paths in (
            ("AMENT_PREFIX_PATH", self.prefixes),
            ("ROS_PACKAGE_PATH", self.ros1_paths),
        ):
            reported.append(f"{variable} ({os.pathsep.join(paths) or 'not set'})")
        return (*reported, *(self._scan(level).words() for level in self.levels(near)))

    def known(self, near: str) -> dict[str, str]:
        """The packages around a file: directories by name, the nearest of each name."""
        found: dict[str, str] = {}
        start = self.directory_of(near)
        for name, at in self._roots.around(start):
            found.setdefault(name, at)
        for level in self.levels(near):
            for name, directory in self._scan(level).all().items():
                found.setdefault(name, directory)
        return found

    def enclosing(self, path: str) -> tuple[str, str] | None:
        """Name and directory of the package that a file lies in."""
        return self._roots.enclosing(self.directory_of(path))

    def workspace(self, near: str) -> str:
        """The repository or workspace of a file, else its package, else its directory."""
        return self.root(near).directory

    def root(self, near: str) -> Root:
        """Where the search for packages that a file refers to ends, and what says so."""
        return self._roots.root(self.directory_of(near))

    def searches(self, directory: str, near: str) -> bool:
        """True if the packages in a directory are looked for on behalf of a file."""
        return any(is_within(directory, level.root) for level in self.levels(near))

    def levels(self, near: str) -> tuple[ScannedDirectory, ...]:
        """What is scanned for packages that a file refers to, from the inside out."""
        return self._roots.levels(self.directory_of(near))

    def gazebo_model_paths(self, near: str) -> Iterator[tuple[str, str]]:
        """What packages export as ``gazebo_model_path``, as package directory and path below it.

        gazebo_ros adds these to Gazebo's model path.
        """
        for directory in self.known(near).values():
            for match in re.finditer(_MODEL_PATH, read_marker(directory, "package.xml")):
                text = (match.group(1) or match.group(2) or b"").decode("utf-8", "replace")
                for path in text.split(":"):
                    prefix, prefixed, relative = path.partition("${prefix}")
                    if prefixed and not prefix:
                        yield directory, relative

    def is_shared(self, directory: str) -> bool:
        """True of home, /tmp and the like, which hold more than one project's things."""
        return directory in self._roots.too_wide

    def name_of(self, directory: str) -> str | None:
        """The name of the package whose directory this is; None if it is no package's."""
        return self._packages.name_of(directory)

    def siblings_named(self, name: str, near: str) -> Iterator[str]:
        """Directories of that name next to those above a file, from the inside out."""
        above = [at for at in upwards(self.directory_of(near)) if self.searches(at, near)]
        for directory in above:
            sibling = os.path.join(directory, name)
            if sibling not in above and disk.is_directory(sibling):
                yield sibling

    def _may_be_around(self, directory: str, near: str) -> bool:
        """False of a directory above a file that lies outside of its repository or workspace."""
        return not self.root(near).mark or self.searches(directory, near)

    def _scan(self, level: ScannedDirectory) -> PackageScan:
        from urdfkit.workspace.package_scan import PackageScan  # most packages are around the robot

        if level not in self._scans:
            depth = DEPTH_INSIDE if level.inside else DEPTH_OUTSIDE
            self._scans[level] = PackageScan(self._packages, level.root, depth, nested=level.inside)
        return self._scans[level]

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
            found = self._scan(ScannedDirectory(path, False)).find(name)
            if found:
                yield found

    def _named(self, name: str, near: str) -> list[str]:
        """The directories of that name around a file, the innermost first."""
        return [
            directory
            for directory in upwards(self.directory_of(near))
            if name
            and os.path.basename(directory) == name
            and directory not in self._roots.too_wide
            if self._may_be_around(directory, near)
        ]


def path_list(environment: Mapping[str, str], variable: str) -> list[str]:
    """The directories that a variable such as ``AMENT_PREFIX_PATH`` names."""
    parts = environment.get(variable, "").split(os.pathsep)
    return [os.path.abspath(part) for part in parts if part]
