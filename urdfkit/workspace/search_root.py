"""Where the search for packages ends.

It ends at the root of the repository or workspace, so that a clone next to it changes
nothing. Going up from the package of a file, the root is

1. the outermost folder of a workspace: one named ``src``, with ``.catkin_workspace`` or
   ``.catkin_tools``, or where colcon put its ``build``, ``install`` or ``log``;
2. widened to, or without a workspace simply, the nearest folder with ``.git``; from a submodule
   on to the repository that has it;
3. else, as in an archive that was unpacked, the outermost folder, not itself a package, with a
   file that belongs to the top of a repository: ``LICENSE``, ``.gitignore``, ``urdfkit.toml``...;
4. else the package; its neighbours count if their folder holds packages only, and no repository;
5. for a file in no package the folder that has its ``meshes``, as ``arm`` of ``arm/urdf/arm.urdf``
   and ``arm/meshes``;
6. else the file's own folder.

Home and the folders that hold the things of many (``/tmp``, ``/opt``) are never in it.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterator, Mapping

from urdfkit.core.record import Record
from urdfkit.workspace.package_folders import PackageFolders, is_searched, is_within, upwards
from urdfkit.workspace.package_scan import PackageScan

#: Depth at which a folder next to a package shows that it holds packages of its own.
DEPTH_OF_REPOSITORIES = 2

_CATKIN = (".catkin_workspace", ".catkin_tools")
_COLCON = ("install", "build", "log")
#: Folders next to that of a description; a robot's are in one of so many folders from its own up.
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
    """The folder at which the search for packages ends.

    Attributes:
        folder: of the repository or workspace; of the package, or the file, if nothing marks one.
        mark: the name in it that decided, such as ``.git``; empty if nothing did.
    """

    folder: str
    mark: str


class ScannedFolder(Record):
    """A folder that is scanned for packages.

    Attributes:
        root: the folder.
        inside: True if it belongs to the same repository or workspace as the file.
    """

    root: str
    inside: bool


class SearchRoots:
    """The repositories and workspaces around files; everything is worked out once."""

    def __init__(self, folders: PackageFolders, environment: Mapping[str, str]) -> None:
        self.too_wide = _too_wide(environment)
        self._folders = folders
        self._roots: dict[str, Root] = {}
        self._levels: dict[str, tuple[ScannedFolder, ...]] = {}

    def root(self, start: str) -> Root:
        """Where the search for packages from a folder ends, and what says so."""
        if start not in self._roots:
            self._roots[start] = self._find_root(start)
        return self._roots[start]

    def levels(self, start: str) -> tuple[ScannedFolder, ...]:
        """What is scanned for packages from a folder, from the inside out."""
        if start not in self._levels:
            self._levels[start] = self._find_levels(start)
        return self._levels[start]

    def enclosing(self, start: str) -> tuple[str, str] | None:
        """Name and folder of the package that a folder lies in."""
        return next(self.around(start), None)

    def around(self, start: str) -> Iterator[tuple[str, str]]:
        """Names and folders of the packages that a folder lies in, up to its repository."""
        for folder in upwards(start):
            name = self._folders.name_of(folder)
            if name:
                yield name, folder
            if self._folders.is_repository(folder):
                return

    def _find_levels(self, start: str) -> tuple[ScannedFolder, ...]:
        above = self._above(start)
        root = self.root(start)
        inside = [ScannedFolder(folder, True) for folder in above if is_within(folder, root.folder)]
        parent = os.path.dirname(root.folder)
        if root.mark or parent not in above or not self._holds_packages_only(parent):
            return tuple(inside)
        return (*inside, ScannedFolder(parent, False))

    def _above(self, start: str) -> list[str]:
        """The package around a folder, else the folder, and what is above that may be a root."""
        package = self.enclosing(start)
        base = package[1] if package else start
        return [folder for folder in upwards(base) if folder not in self.too_wide]

    def _find_root(self, start: str) -> Root:
        above = self._above(start)
        root = None
        is_closed = False  # a repository ends the search, but for a workspace around it
        for folder in above:
            mark = self._mark_of_workspace(folder, above)
            if mark:
                root, is_closed = Root(folder, mark), False
            elif not is_closed and ".git" in self._folders.names_in(folder):
                root, is_closed = Root(folder, ".git"), self._folders.is_repository(folder)
        root = root or self._unpacked(above)
        return root or Root(self._with_meshes(start, above) or (above or [start])[0], "")

    def _unpacked(self, above: list[str]) -> Root | None:
        """The root of a repository without its ``.git``, as in an archive."""
        for folder in reversed(above):
            names = () if self._folders.name_of(folder) else self._folders.names_in(folder)
            mark = next((n for n in sorted(names) if re.fullmatch(_AT_THE_TOP, n)), "")
            if mark:
                return Root(folder, mark)
        return None

    def _with_meshes(self, start: str, above: list[str]) -> str | None:
        """The folder of a robot that was copied without its ``package.xml``."""
        if self.enclosing(start):
            return None
        for folder in above[:_LEVELS_TO_MESHES]:
            names = self._folders.names_in(folder)
            if any(names.get(name) for name in _NEXT_TO_URDF):
                return folder
        return None

    def _mark_of_workspace(self, folder: str, above: list[str]) -> str:
        """What makes a folder a workspace of catkin or colcon; empty if nothing does."""
        is_named = os.path.basename(folder) == "src" and folder != above[0]
        if is_named and os.path.dirname(folder) in above:
            return "src"
        names = self._folders.names_in(folder)
        made = (name for name in _COLCON if names.get(name))
        ignored = (os.path.join(name, "COLCON_IGNORE") for name in made)
        catkin = next((name for name in _CATKIN if name in names), "")
        return catkin or next(
            (path for path in ignored if self._folders.listings.find(folder, path)), ""
        )

    def _holds_packages_only(self, folder: str) -> bool:
        """True of several packages and no folder of packages: those of one repository."""
        inside = [os.path.join(folder, n) for n, is_folder in self._folders.names_in(folder).items()
                  if is_folder and is_searched(n)]  # fmt: skip
        others = [at for at in inside if not self._folders.name_of(at)]
        if len(inside) - len(others) < 2 or any(
            ".git" in self._folders.names_in(at) for at in inside
        ):
            return False
        return not any(
            PackageScan(self._folders, at, DEPTH_OF_REPOSITORIES, nested=False).all()
            for at in others
        )


def _too_wide(environment: Mapping[str, str]) -> frozenset[str]:
    """Folders that hold more than one project's things: never scanned, never a workspace."""
    folders = set(_SHARED_BY_ALL)
    for shared in (os.path.expanduser("~"), environment.get("HOME"), environment.get("TMPDIR")):
        if shared:
            folders.update(upwards(os.path.abspath(shared)))
    return frozenset(folders)
