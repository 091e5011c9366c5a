"""The root of the search for packages.

It is the root of the repository or workspace, so that an unrelated clone next to it does not change
the result. Upwards from the package of a file, the root is

1. the outermost directory of a workspace: named ``src``, with ``.catkin_workspace`` or
   ``.catkin_tools``, or with colcon's ``build``, ``install`` or ``log``;
2. extended to (or without a workspace simply) the nearest directory with ``.git``; for a submodule,
   the repository that contains it;
3. otherwise, as in an unpacked archive, the outermost directory, not itself a package, with a file
   that is typical of the top of a repository: ``LICENSE``, ``.gitignore``, ``urdfkit.toml``...;
4. otherwise the outermost directory around it with several packages and no repository, if one of
   them depends on another, as does one in each subdirectory of packages;
5. otherwise the package; packages next to it count if their directory contains only packages, and
   no repository;
6. for a file without a package, the directory with its ``meshes``, such as ``arm`` for
   ``arm/urdf/arm.urdf`` and ``arm/meshes``;
7. otherwise the file's own directory.

Home and directories shared by many projects (``/tmp``, ``/opt``) are never a root.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping
from functools import lru_cache

from urdfkit.core.memo import LIMIT
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.record import Record
from urdfkit.workspace.directories import is_walked
from urdfkit.workspace.package_directories import PackageDirectories, dependencies, read_marker

#: Depth of the search for packages in a directory next to a package.
SIBLING_DEPTH = 2

_CATKIN = (".catkin_workspace", ".catkin_tools")
_COLCON = ("install", "build", "log")
#: Names of mesh directories, and the number of directories from the description upwards to search.
_MESH_DIRECTORIES, _MESH_LEVELS = ("meshes", "mesh"), 3
#: Files at the top of a repository, also in an archive without ``.git``.
_TOP_FILES = (
    r"(?i)(?:licen[sc]e|copying)(?:[.-].*)?|\.git(?:hub|ignore|attributes|modules|lab-ci\.yml)"
    r"|\.travis\.yml|\.pre-commit-config\.yaml|urdfkit\.toml|pyproject\.toml"
)

_SYSTEM_DIRECTORIES = frozenset(
    "/ /dev /etc /home /media /mnt /opt /private /proc /root /run /srv /sys /tmp /usr /usr/share "
    "/usr/local /usr/src /var /var/tmp /Users /Volumes".split()
)


class Root(Record):
    """The outermost directory of the search for packages."""

    directory: str  # of the repository or workspace; otherwise of the package, or of the file
    mark: str  # the entry that marks it as root, such as ``.git``; empty if there is none


class ScannedDirectory(Record):
    """A directory that is scanned for packages."""

    root: str
    inside: bool  # True if it is in the same repository or workspace as the file


class SearchRoots:
    """The repositories and workspaces of files, cached."""

    def __init__(self, directories: PackageDirectories, environment: Mapping[str, str]) -> None:
        self.shared = _shared_directories(environment)
        self._directories = directories
        #: The root of the search for packages from a directory.
        self.root: Callable[[str], Root] = lru_cache(LIMIT)(self._find_root)
        #: The directories that are scanned for packages from a directory, innermost first.
        self.levels: Callable[[str], tuple[ScannedDirectory, ...]]
        self.levels = lru_cache(LIMIT)(self._find_levels)
        #: True if a package depends on another one, as does each subdirectory of packages.
        self._has_dependent_packages: Callable[[str], bool]
        self._has_dependent_packages = lru_cache(LIMIT)(self._find_dependent_packages)
        self._packages_below: Callable[[str], list[dict[str, str]]]
        self._packages_below = lru_cache(LIMIT)(self._find_packages_below)

    def enclosing(self, start: str) -> tuple[str, str] | None:
        """Name and directory of the innermost package that contains a directory."""
        return next(self.enclosing_packages(start), None)

    def enclosing_packages(self, start: str) -> Iterator[tuple[str, str]]:
        """Names and directories of the packages that contain a directory, up to its repository."""
        for directory in upwards(start):
            name = self._directories.name_of(directory)
            if name:
                yield name, directory
            if self._directories.is_repository(directory):
                return

    def _find_levels(self, start: str) -> tuple[ScannedDirectory, ...]:
        parents = self._possible_roots(start)
        root = self.root(start)
        inside = [
            ScannedDirectory(directory, True)
            for directory in parents
            if is_within(directory, root.directory)
        ]
        parent = os.path.dirname(root.directory)
        if root.mark or parent not in parents or not self._has_only_packages(parent):
            return tuple(inside)
        return (*inside, ScannedDirectory(parent, False))

    def _possible_roots(self, start: str) -> list[str]:
        """The package of a directory, or the directory itself, and their unshared parents."""
        package = self.enclosing(start)
        base = package[1] if package else start
        return [directory for directory in upwards(base) if directory not in self.shared]

    def _find_root(self, start: str) -> Root:
        parents = self._possible_roots(start)
        root = None
        is_closed = False  # a repository ends the search, except for a workspace that contains it
        for directory in parents:
            mark = self._workspace_mark(directory, parents)
            if mark:
                root, is_closed = Root(directory, mark), False
            elif not is_closed and ".git" in self._directories.names_in(directory):
                root, is_closed = (
                    Root(directory, ".git"),
                    self._directories.is_repository(directory),
                )
        root = root or self._archive_root(parents) or self._with_dependencies(start, parents)
        return root or Root(self._with_meshes(start, parents) or (parents or [start])[0], "")

    def _archive_root(self, parents: list[str]) -> Root | None:
        """The root of a repository without ``.git``, as in an archive."""
        for directory in reversed(parents):
            names = (
                ()
                if self._directories.name_of(directory)
                else self._directories.names_in(directory)
            )
            mark = next((n for n in sorted(names) if re.fullmatch(_TOP_FILES, n)), "")
            if mark:
                return Root(directory, mark)
        return None

    def _with_dependencies(self, start: str, parents: list[str]) -> Root | None:
        """The outermost directory of packages, if they are not those of unrelated repositories."""
        if not self.enclosing(start):
            return None
        directories = reversed(parents[1 : 1 + SIBLING_DEPTH])
        found = next(filter(self._has_dependent_packages, directories), None)
        return Root(found, "package.xml") if found else None

    def _find_dependent_packages(self, directory: str) -> bool:
        groups = self._packages_below(directory)
        needs = [
            {name for at in group.values() for name in dependencies(read_marker(at, "package.xml"))}
            for group in groups
        ]
        owners = Counter(name for group in groups for name in group)
        users = Counter(name for names in needs for name in names)

        def is_dependent(group: dict[str, str], names: set[str]) -> bool:
            needs_another = any(owners[name] > (name in group) for name in names)
            return needs_another or any(users[name] > (name in names) for name in group)

        dependent = list(map(is_dependent, groups, needs))
        return any(dependent) and all(
            is_joined or directory in map(os.path.dirname, group.values())
            for group, is_joined in zip(groups, dependent, strict=True)
        )

    def _with_meshes(self, start: str, parents: list[str]) -> str | None:
        """The directory of a robot that was copied without its ``package.xml``."""
        if self.enclosing(start):
            return None
        for directory in parents[:_MESH_LEVELS]:
            names = self._directories.names_in(directory)
            if any(names.get(name) for name in _MESH_DIRECTORIES):
                return directory
        return None

    def _workspace_mark(self, directory: str, parents: list[str]) -> str:
        """The entry that marks a workspace of catkin or colcon; empty if there is none."""
        is_src = os.path.basename(directory) == "src" and directory != parents[0]
        if is_src and os.path.dirname(directory) in parents:
            return "src"
        names = self._directories.names_in(directory)
        built = (name for name in _COLCON if names.get(name))
        ignored = (os.path.join(name, "COLCON_IGNORE") for name in built)
        catkin = next((name for name in _CATKIN if name in names), "")
        return catkin or next(
            (path for path in ignored if self._directories.listings.find(directory, path)), ""
        )

    def _has_only_packages(self, directory: str) -> bool:
        """True for a directory of several packages without nested packages or repositories."""
        groups = self._packages_below(directory)
        return bool(groups) and all(
            os.path.dirname(at) == directory for group in groups for at in group.values()
        )

    def _find_packages_below(self, directory: str) -> list[dict[str, str]]:
        """The packages of each subdirectory that has some; none of a directory of repositories."""
        names = self._directories.names_in(directory).items()
        inside = [os.path.join(directory, n) for n, is_dir in names if is_dir and is_walked(n)]
        itself = {at: name for at in inside if (name := self._directories.name_of(at))}
        if len(itself) < 2 or any(".git" in self._directories.names_in(at) for at in inside):
            return []
        from urdfkit.workspace.package_scan import PackageScan

        others = (
            PackageScan(self._directories, at, SIBLING_DEPTH, nested=False).all()
            for at in inside
            if at not in itself
        )
        return [*({name: at} for at, name in itself.items()), *filter(None, others)]


def _shared_directories(environment: Mapping[str, str]) -> frozenset[str]:
    """Directories with files of many projects, which are never scanned and never a workspace."""
    directories = set(_SYSTEM_DIRECTORIES)
    for shared in (os.path.expanduser("~"), environment.get("HOME"), environment.get("TMPDIR")):
        if shared:
            directories.update(upwards(os.path.abspath(shared)))
    return frozenset(directories)
