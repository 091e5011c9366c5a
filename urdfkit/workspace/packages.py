"""Finding ROS packages without ROS.

The search ends at the root of the repository or workspace, so that a clone next to it changes
nothing. Going up from the package of a file, the root is

1. the outermost folder of a workspace: one named ``src``, with ``.catkin_workspace`` or
   ``.catkin_tools``, or where colcon put its ``build``, ``install`` or ``log``;
2. widened to, or without a workspace simply, the nearest folder with ``.git``; from a submodule
   on to the repository that has it;
3. else, as in an archive that was unpacked, the outermost folder, not itself a package, with a
   file that belongs to the top of a repository: ``LICENSE``, ``.gitignore``, ``urdfkit.toml``...;
4. else nothing is known, and it is the package (or the file's own folder). The packages next to it
   count if their folder holds packages only, and no repository.

Home and the folders that hold the things of many (``/tmp``, ``/opt``) are never in it.
"""

from __future__ import annotations

import os
import re
import time
from collections.abc import Iterator, Mapping
from functools import lru_cache

from urdfkit.core.record import Record
from urdfkit.text.comments import without_comments
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.folders import Folders

#: A scan stops here and says so. Real workspaces have some thousand folders.
MAX_FOLDERS = 20_000
MAX_SECONDS = 2.0
#: Depth of a scan inside a repository or workspace, and of one outside of it.
DEPTH_INSIDE = 12
DEPTH_OUTSIDE = 4
#: Depth at which a folder next to a package shows that it holds packages of its own.
DEPTH_OF_REPOSITORIES = 2

_CATKIN = (".catkin_workspace", ".catkin_tools")
_COLCON = ("install", "build", "log")
#: What lies at the top of a repository, also where an archive left out ``.git``.
_AT_THE_TOP = (
    r"(?i)(?:licen[sc]e|copying)(?:[.-].*)?|\.git(?:hub|ignore|attributes|modules|lab-ci\.yml)"
    r"|\.travis\.yml|\.pre-commit-config\.yaml|urdfkit\.toml|pyproject\.toml"
)

_NOT_SOURCES = frozenset("build devel install log node_modules __pycache__ site-packages".split())
_SHARED_BY_ALL = frozenset(
    "/ /dev /etc /home /media /mnt /opt /private /proc /root /run /srv /sys /tmp /usr /usr/share "
    "/usr/local /usr/src /var /var/tmp /Users /Volumes".split()
)
_MODEL_PATH = rb"""\bgazebo_model_path\s*=\s*(?:"([^"]*)"|'([^']*)')"""


class Candidate(Record):
    """A folder that may be the package of a name.

    Attributes:
        folder: the package's folder.
        certain: False if it only has the name of the package, without a ``package.xml``.
        trusted: True if the environment of the user names it.
    """

    folder: str
    certain: bool = True
    trusted: bool = False


class ScannedFolder(Record):
    """A folder that is scanned for packages.

    Attributes:
        root: the folder.
        inside: True if it belongs to the same repository or workspace as the file.
    """

    root: str
    inside: bool


class Root(Record):
    """The folder at which the search for packages ends.

    Attributes:
        folder: of the repository or workspace; of the package, or the file, if nothing marks one.
        mark: the name in it that decided, such as ``.git``; empty if nothing did.
    """

    folder: str
    mark: str


class Packages:
    """Finds packages; everything is read once.

    Args:
        explicit: folders by package name, which win over every search.
        environment: ``AMENT_PREFIX_PATH`` and ``ROS_PACKAGE_PATH`` are read from it.
        folders: the listings to use.
    """

    def __init__(
        self, explicit: Mapping[str, str], environment: Mapping[str, str], folders: Folders
    ) -> None:
        self.explicit = {name: os.path.abspath(folder) for name, folder in explicit.items()}
        self.folders = folders
        self.prefixes = path_list(environment, "AMENT_PREFIX_PATH")
        self.ros1_paths = path_list(environment, "ROS_PACKAGE_PATH")
        self._too_wide = _too_wide(environment)
        self._names: dict[str, str | None] = {}
        self._roots: dict[str, Root] = {}
        self._levels: dict[str, tuple[ScannedFolder, ...]] = {}
        self._scans: dict[ScannedFolder, _Scan] = {}
        self._searched: dict[str, tuple[str, ...]] = {}
        self._folders_of: dict[str, str] = {}

    def folder_of(self, path: str) -> str:
        """The absolute folder of a file; worked out once, as a robot names a hundred meshes."""
        if path not in self._folders_of:
            self._folders_of[path] = os.path.dirname(os.path.abspath(path))
        return self._folders_of[path]

    def candidates(self, name: str, near: str) -> Iterator[Candidate]:
        """The folders that may be a package, the best first of those that are certain.

        Args:
            name: of the package.
            near: path of the file that refers to it.
        """
        if name in self.explicit:
            if os.path.isdir(self.explicit[name]):
                yield Candidate(self.explicit[name])
            return
        if name in ("", ".", "..") or "/" in name or "\\" in name:
            return  # a path; below AMENT_PREFIX_PATH it would lead to any folder
        start = self.folder_of(near)
        yield from (Candidate(at) for own, at in self._around(start) if own == name)
        for folder in self._in_environment(name):
            yield Candidate(folder, trusted=True)
        # A build may install this folder under its name, whatever package.xml lies elsewhere.
        yield from (Candidate(at, certain=False) for at in self._named(name, near))
        for level in self.levels(near):
            found = self._scan(level).find(name)
            if found:
                yield Candidate(found)
        for folder in self._by_folder_name(name, near):
            yield Candidate(folder, certain=False)

    def searched(self, name: str, near: str) -> tuple[str, ...]:
        """Where ``candidates`` looks, in words a user can check."""
        if name in self.explicit:
            return (f"{self.explicit[name]} (given for {name}; no such directory)",)
        start = self.folder_of(near)
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
        """The packages around a file: folders by name, the nearest of each name."""
        found: dict[str, str] = {}
        start = self.folder_of(near)
        for name, at in self._around(start):
            found.setdefault(name, at)
        for level in self.levels(near):
            for name, folder in self._scan(level).all().items():
                found.setdefault(name, folder)
        return found

    def enclosing(self, path: str) -> tuple[str, str] | None:
        """Name and folder of the package that a file lies in."""
        return next(self._around(self.folder_of(path)), None)

    def _around(self, start: str) -> Iterator[tuple[str, str]]:
        """Names and folders of the packages that a folder lies in, up to its repository."""
        for folder in _upwards(start):
            name = self.name_of(folder)
            if name:
                yield name, folder
            if self._is_repository(folder):
                return

    def workspace(self, near: str) -> str:
        """The folder that a file belongs to: its repository or workspace, package or folder."""
        return self.root(near).folder

    def root(self, near: str) -> Root:
        """Where the search for packages that a file refers to ends, and what says so."""
        start = self.folder_of(near)
        if start not in self._roots:
            self._roots[start] = self._find_root(start)
        return self._roots[start]

    def searches(self, folder: str, near: str) -> bool:
        """True if the packages in a folder are looked for on behalf of a file."""
        return any(_is_within(folder, level.root) for level in self.levels(near))

    def levels(self, near: str) -> tuple[ScannedFolder, ...]:
        """What is scanned for packages that a file refers to, from the inside out."""
        start = self.folder_of(near)
        if start not in self._levels:
            self._levels[start] = self._find_levels(start)
        return self._levels[start]

    def gazebo_model_paths(self, near: str) -> Iterator[tuple[str, str]]:
        """What packages export as ``gazebo_model_path``, as package folder and path below it.

        gazebo_ros adds these to Gazebo's model path.
        """
        for folder in self.known(near).values():
            for match in re.finditer(_MODEL_PATH, _read_marker(folder, "package.xml")):
                text = (match.group(1) or match.group(2) or b"").decode("utf-8", "replace")
                for path in text.split(":"):
                    prefix, prefixed, relative = path.partition("${prefix}")
                    if prefixed and not prefix:
                        yield folder, relative

    def name_of(self, folder: str) -> str | None:
        """The name of the package whose folder this is; None if it is no package's."""
        if folder not in self._names:
            self._names[folder] = _package_name(folder)
        return self._names[folder]

    def _find_levels(self, start: str) -> tuple[ScannedFolder, ...]:
        above = self._above(start)
        root = self.root(os.path.join(start, "x"))
        inside = [
            ScannedFolder(folder, True) for folder in above if _is_within(folder, root.folder)
        ]
        parent = os.path.dirname(root.folder)
        if root.mark or parent not in above or not self._holds_packages_only(parent):
            return tuple(inside)
        return (*inside, ScannedFolder(parent, False))

    def _above(self, start: str) -> list[str]:
        """The package around a folder, else the folder, and what is above that may be a root."""
        package = self.enclosing(os.path.join(start, "x"))
        base = package[1] if package else start
        return [folder for folder in _upwards(base) if folder not in self._too_wide]

    def _find_root(self, start: str) -> Root:
        above = self._above(start)
        root = None
        is_closed = False  # a repository ends the search, but for a workspace around it
        for folder in above:
            mark = self._mark_of_workspace(folder, above)
            if mark:
                root, is_closed = Root(folder, mark), False
            elif not is_closed and ".git" in self._names_in(folder):
                root, is_closed = Root(folder, ".git"), self._is_repository(folder)
        return root or self._unpacked(above) or Root(above[0] if above else start, "")

    def _unpacked(self, above: list[str]) -> Root | None:
        """The root of a repository without its ``.git``, as in an archive."""
        for folder in reversed(above):
            names = () if self.name_of(folder) else self._names_in(folder)
            mark = next((n for n in sorted(names) if re.fullmatch(_AT_THE_TOP, n)), "")
            if mark:
                return Root(folder, mark)
        return None

    def _mark_of_workspace(self, folder: str, above: list[str]) -> str:
        """What makes a folder a workspace of catkin or colcon; empty if nothing does."""
        is_named = os.path.basename(folder) == "src" and folder != above[0]
        if is_named and os.path.dirname(folder) in above:
            return "src"
        names = self._names_in(folder)
        made = (name for name in _COLCON if names.get(name))
        ignored = (os.path.join(name, "COLCON_IGNORE") for name in made)
        catkin = next((name for name in _CATKIN if name in names), "")
        return catkin or next((path for path in ignored if self.folders.find(folder, path)), "")

    def _holds_packages_only(self, folder: str) -> bool:
        """True of several packages and no folder of packages: those of one repository."""
        inside = [os.path.join(folder, n) for n, is_folder in self._names_in(folder).items()
                  if is_folder and _is_searched(n)]  # fmt: skip
        others = [at for at in inside if not self.name_of(at)]
        if len(inside) - len(others) < 2 or any(".git" in self._names_in(at) for at in inside):
            return False
        return not any(_Scan(self, at, DEPTH_OF_REPOSITORIES, nested=False).all() for at in others)

    def _may_be_around(self, folder: str, near: str) -> bool:
        """False of a folder above a file that lies outside of its repository or workspace."""
        return not self.root(near).mark or self.searches(folder, near)

    def _is_repository(self, folder: str) -> bool:
        """True of the top of a repository, unless it is a submodule of another one."""
        is_marked = ".git" in self._names_in(folder)
        return is_marked and b"/modules/" not in read_head(os.path.join(folder, ".git"), 4096)

    def _names_in(self, folder: str) -> Mapping[str, bool]:
        return self.folders.entries(folder) or {}

    def _scan(self, level: ScannedFolder) -> _Scan:
        if level not in self._scans:
            depth = DEPTH_INSIDE if level.inside else DEPTH_OUTSIDE
            self._scans[level] = _Scan(self, level.root, depth, nested=level.inside)
        return self._scans[level]

    def _in_environment(self, name: str) -> Iterator[str]:
        for prefix in self.prefixes:
            folder = os.path.join(prefix, "share", name)
            if os.path.isdir(folder):
                yield folder
        for path in self.ros1_paths:
            if self.name_of(path) == name:
                yield path
            direct = os.path.join(path, name)
            if self.name_of(direct) == name:
                yield direct
            found = self._scan(ScannedFolder(path, False)).find(name)
            if found:
                yield found

    def _named(self, name: str, near: str) -> list[str]:
        """The folders of that name around a file, the innermost first."""
        return [
            folder
            for folder in _upwards(self.folder_of(near))
            if name and os.path.basename(folder) == name and folder not in self._too_wide
            if self._may_be_around(folder, near)
        ]

    def _by_folder_name(self, name: str, near: str) -> Iterator[str]:
        """Folders of that name beside those above a file."""
        above = [at for at in _upwards(self.folder_of(near)) if self.searches(at, near)]
        for folder in above:
            beside = os.path.join(folder, name)
            if beside not in above and os.path.isdir(beside):
                yield beside


class _Scan:
    """The packages below a folder, breadth first, no further than has been asked for.

    Of two packages with one name, the nearest to the root counts, then the first by path.
    """

    def __init__(self, packages: Packages, root: str, depth: int, *, nested: bool) -> None:
        self.root = root
        self._packages = packages
        self._depth = depth
        self._nested = nested
        self._queue: list[tuple[str, int]] = [(root, 0)]
        self._next = 0
        self._seconds = 0.0
        self._found: dict[str, str] = {}
        self._linked: set[str] = set()

    def find(self, name: str) -> str | None:
        started = time.monotonic()
        while name not in self._found and self._more(started):
            self._visit(*self._queue[self._next])
            self._next += 1
        self._seconds += time.monotonic() - started
        return self._found.get(name)

    def all(self) -> dict[str, str]:
        """Folders of all packages by name."""
        self.find("")
        return self._found

    def words(self) -> str:
        """What was scanned, and how far."""
        self.find("")
        count = len(self._found)
        stopped = (
            "" if self._next == len(self._queue) else f", stopped after {self._next} directories"
        )
        return f"{self.root} ({count} package{'' if count == 1 else 's'}{stopped})"

    def _more(self, started: float) -> bool:
        return (
            self._next < min(len(self._queue), MAX_FOLDERS)
            and self._seconds + time.monotonic() - started < MAX_SECONDS
        )

    def _visit(self, folder: str, depth: int) -> None:
        entries = self._packages.folders.entries(folder) or {}
        if "package.xml" in entries or "manifest.xml" in entries:
            name = self._packages.name_of(folder)
            if name:
                self._found.setdefault(name, folder)
                if not self._nested and depth:
                    return
        if depth >= self._depth:
            return
        for entry in sorted(entries):
            if entries[entry] and _is_searched(entry):
                path = os.path.join(folder, entry)
                if not self._in_a_circle(path):
                    self._queue.append((path, depth + 1))

    def _in_a_circle(self, path: str) -> bool:
        """True if a symbolic link leads to where another led, or to a folder around it."""
        if not self._packages.folders.is_link(path):
            return False
        real = os.path.realpath(path)
        if real in self._linked or (path + os.sep).startswith(real + os.sep):
            return True
        self._linked.add(real)
        return False


def _is_searched(name: str) -> bool:
    """False of hidden folders, and of those that a build makes."""
    return name[0] != "." and name not in _NOT_SOURCES


def _is_within(path: str, folder: str) -> bool:
    return os.path.join(path, "").startswith(os.path.join(folder, ""))


def _package_name(folder: str) -> str | None:
    data = _read_marker(folder, "package.xml")
    if data:
        name = data.partition(b"<name>")[2].partition(b"</name>")[0].strip()
        is_one = b"<" not in name and len(name.split()) == 1
        return name.decode("utf-8", "replace") if is_one else None
    # rosbuild: the name is that of the folder.
    if b"<package" in _read_marker(folder, "manifest.xml"):
        return os.path.basename(folder)
    return None


def _read_marker(folder: str, name: str) -> bytes:
    """A package.xml or manifest.xml without its comments; empty if there is none."""
    return without_comments(read_head(os.path.join(folder, name), 65_536))


@lru_cache(maxsize=1024)
def _upwards(folder: str) -> tuple[str, ...]:
    """A folder and those above it, the innermost first."""
    above = os.path.dirname(folder)
    return (folder,) if above == folder else (folder, *_upwards(above))


def path_list(environment: Mapping[str, str], variable: str) -> list[str]:
    """The folders that a variable such as ``AMENT_PREFIX_PATH`` names."""
    parts = environment.get(variable, "").split(os.pathsep)
    return [os.path.abspath(part) for part in parts if part]


def _too_wide(environment: Mapping[str, str]) -> frozenset[str]:
    """Folders that hold more than one project's things: never scanned, never a workspace."""
    folders = set(_SHARED_BY_ALL)
    for shared in (os.path.expanduser("~"), environment.get("HOME"), environment.get("TMPDIR")):
        if shared:
            folders.update(_upwards(os.path.abspath(shared)))
    return frozenset(folders)
