"""Where the search for packages ends.

It ends at the root of the repository or workspace, so that a clone next to it changes
nothing. Going up from the package of a file, the root is

1. the outermost directory of a workspace: one named ``src``, with ``.catkin_workspace`` or
   ``.catkin_tools``, or where colcon put its ``build``, ``install`` or ``log``;
2. widened to, or without a workspace simply, the nearest directory with ``.git``; from a submodule
   on to the repository that has it;
3. else, as in an archive that was unpacked, the outermost directory, not itself a package, with a
   file that belongs to the top of a repository: ``LICENSE``, ``.gitignore``, ``urdfkit.toml``...;
4. else the package; its neighbours count if their directory holds packages only, and no
   repository;
5. for a file in no package the directory that has its ``meshes``, as ``arm`` of
   ``arm/urdf/arm.urdf`` and ``arm/meshes``;
6. else the file's own directory.

Home and the directories that hold the things of many (``/tmp``, ``/opt``) are never in it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfkit.core.memo import Memo
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.record import Record
from urdfkit.workspace.directories import is_walked
from urdfkit.workspace.package_directories import PackageDirectories

#: Depth at which a directory next to a package shows that it holds packages of its own.
DEPTH_OF_REPOSITORIES = 2

_CATKIN = (".catkin_workspace", ".catkin_tools")
_COLCON = ("install", "build", "log")
#: Names of mesh directories; they are looked for in the directory of a description and above it.
_NEXT_TO_URDF, _LEVELS_TO_MESHES = ("meshes", "mesh"), 3
#: What lies at the top of a repository, also where an archive left out ``.git``.
_AT_THE_TOP = (
    r"(?i)(?:licen[sc]e|copying)(?:[.-].*)?|\.git(?:hub|ignore|attributes|modules|lab-ci\.yml)"
    r"|\.travis\.yml|\.pre-commit-config\.yaml|urdfkit\.toml|pyproject\.toml"
)

_SHARED_BY_ALL = frozenset(
    "/ /dev /etc /home /media /mnt /opt /private /proc /root /run /srv /sys /tmp /usr /usr/share "
    "/usr/local /usr/src /var /var/tmp /Users /Volumes".split()
)


class Root(Record):
    """The directory at which the search for packages ends."""

    directory: str  # of the repository or workspace, else of the package, else of the file
    mark: str  # the name in it that decided, such as ``.git``; empty if nothing did


class ScannedDirectory(Record):
    """A directory that is scanned for packages."""

    root: str  # the directory
    inside: bool  # True if it belongs to the same repository or workspace as the file


class SearchRoots:
    """The repositories and workspaces around files; everything is worked out once."""

    def __init__(self, directories: PackageDirectories, environment: Mapping[str, str]) -> None:
        self.too_wide = _too_wide(environment)
        self._directories = directories
        self._roots: Memo[str, Root] = Memo()
        self._levels: Memo[str, tuple[ScannedDirectory, ...]] = Memo()

    def root(self, start: str) -> Root:
        """Where the search for packages from a directory ends, and what says so."""
        if start not in self._roots:
            self._roots[start] = self._find_root(start)
        return self._roots[start]

    def levels(self, start: str) -> tuple[ScannedDirectory, ...]:
        """What is scanned for packages from a directory, from the inside out."""
        if start not in self._levels:
            self._levels[start] = self._find_levels(start)
        return self._levels[start]

    def enclosing(self, start: str) -> tuple[str, str] | None:
        """Name and directory of the package that a directory lies in."""
        return next(self.around(start), None)

    def around(self, start: str) -> Iterator[tuple[str, str]]:
        """Names and directories of the packages that a directory lies in, up to its repository."""
        for directory in upwards(start):
            name = self._directories.name_of(directory)
            if name:
                yield name, directory
            if self._directories.is_repository(directory):
                return

    def _find_levels(self, start: str) -> tuple[ScannedDirectory, ...]:
        above = self._above(start)
        root = self.root(start)
        inside = [
            ScannedDirectory(directory, True)
            for directory in above
            if is_within(directory, root.directory)
        ]
        parent = os.path.dirname(root.directory)
        if root.mark or parent not in above or not self._holds_packages_only(parent):
            return tuple(inside)
        return (*inside, ScannedDirectory(parent, False))

    def _above(self, start: str) -> list[str]:
        """The package around a directory, or itself, and what is above that may be a root."""
        package = self.enclosing(start)
        base = package[1] if package else start
        return [directory for directory in upwards(base) if directory not in self.too_wide]

    def _find_root(self, start: str) -> Root:
        above = self._above(start)
        root = None
        is_closed = False  # a repository ends the search, but for a workspace around it
        for directory in above:
            mark = self._mark_of_workspace(directory, above)
            if mark:
                root, is_closed = Root(directory, mark), False
            elif not is_closed and ".git" in self._directories.names_in(directory):
                root, is_closed = (
                    Root(directory, ".git"),
                    self._directories.is_repository(directory),
                )
        root = root or self._unpacked(above)
        return root or Root(self._with_meshes(start, above) or (above or [start])[0], "")

    def _unpacked(self, above: list[str]) -> Root | None:
        """The root of a repository without its ``.git``, as in an archive."""
        for directory in reversed(above):
            names = (
                ()
                if self._directories.name_of(directory)
                else self._directories.names_in(directory)
            )
            mark = next((n for n in sorted(names) if re.fullmatch(_AT_THE_TOP, n)), "")
            if mark:
                return Root(directory, mark)
        return None

    def _with_meshes(self, start: str, above: list[str]) -> str | None:
        """The directory of a robot that was copied without its ``package.xml``."""
        if self.enclosing(start):
            return None
        for directory in above[:_LEVELS_TO_MESHES]:
            names = self._directories.names_in(directory)
            if any(names.get(name) for name in _NEXT_TO_URDF):
                return directory
        return None

    def _mark_of_workspace(self, directory: str, above: list[str]) -> str:
        """What makes a directory a workspace of catkin or colcon; empty if nothing does."""
        is_named = os.path.basename(directory) == "src" and directory != above[0]
        if is_named and os.path.dirname(directory) in above:
            return "src"
        names = self._directories.names_in(directory)
        made = (name for name in _COLCON if names.get(name))
        ignored = (os.path.join(name, "COLCON_IGNORE") for name in made)
        catkin = next((name for name in _CATKIN if name in names), "")
        return catkin or next(
            (path for path in ignored if self._directories.listings.find(directory, path)), ""
        )

    def _holds_packages_only(self, directory: str) -> bool:
        """True of several packages and no directory of packages: those of one repository."""
        names = self._directories.names_in(directory).items()
        inside = [os.path.join(directory, n) for n, is_dir in names if is_dir and is_walked(n)]
        others = [at for at in inside if not self._directories.name_of(at)]
        if len(inside) - len(others) < 2 or any(
            ".git" in self._directories.names_in(at) for at in inside
        ):
            return False
        from urdfkit.workspace.package_scan import PackageScan

        return not any(
            PackageScan(self._directories, at, DEPTH_OF_REPOSITORIES, nested=False).all()
            for at in others
        )


def _too_wide(environment: Mapping[str, str]) -> frozenset[str]:
    """Directories that hold more than one project's things: never scanned, never a workspace."""
    directories = set(_SHARED_BY_ALL)
    for shared in (os.path.expanduser("~"), environment.get("HOME"), environment.get("TMPDIR")):
        if shared:
            directories.update(upwards(os.path.abspath(shared)))
    return frozenset(directories)
