"""Which files of a directory are robots: its entry points, by the include graph.

A xacro that another file includes is checked through that file, not alone. Includes are read from
the text, without expanding anything, so that a change of one file leads to the robots it is part
of in a few milliseconds per file.
"""

import os
from collections.abc import Iterable, Iterator
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config, RobotEntry, matches
from urdfkit.lint.entry_points import ROOT, DirectoryContents, EntryPoints
from urdfkit.lint.include_graph import SUFFIXES, IncludeGraph
from urdfkit.text.comments import without_comments
from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.resolve import Resolver

#: Files of one directory that are looked at.
MAX_FILES = 20_000

#: Of files that descriptions include.
_INCLUDED = (*SUFFIXES, ".gazebo", ".trans", ".xml")
#: Of files that hold no robot; the others are looked into.
_NO_ROBOTS = frozenset(
    ".bmp .bt .c .cc .cfg .cmake .cpp .csv .dae .db3 .gif .glb .gltf .gz .h .hpp .htm .html .ipynb "
    ".jpeg .jpg .js .json .launch .lua .material .mcap .md .mp4 .msg .mtl .obj .pcd .pdf .pgm .ply "
    ".png .py .rst .rviz .sdf .sh .srdf .srv .step .stl .stp .svg .tga .toml .ttf .txt .usd .webp "
    ".world .yaml .yml .zip".split()
)
#: Bytes of a file in which its root is looked for.
_HEAD = 4096
_MARK = b"\xef\xbb\xbf"
_NOT_CONFIGURED = "no [[robot]] in the configuration for it"


def discover(directory: str, config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points of a directory: those of the configuration in it, else by the includes.

    Raises:
        UnreadableFile: the directory cannot be read, or holds no description.
    """
    entry_points = _entry_points(directory, config, resolver)
    found = entry_points.contents()
    top = os.path.abspath(directory)
    configured = tuple(robot for robot in config.robots if is_within(robot.file, top))
    if configured:
        named = {disk.real(robot.file) for robot in configured}
        reached = {path for robot in named for path in entry_points.graph.closure(robot)}
        left = [one.file for one in found.robots if disk.real(one.file) not in reached]
        return DirectoryContents(configured, (), others=dict.fromkeys(left, _NOT_CONFIGURED))
    if not any(found):
        excluded = f", not counting what 'exclude' in {config.path} names" if config.exclude else ""
        raise UnreadableFile(
            f"{directory}: contains no .urdf, no .xacro with a <robot> and no launch file{excluded}"
        )
    return found


def _entry_points(directory: str, config: Config, resolver: Resolver) -> EntryPoints:
    """Of the descriptions of a directory, and of what looks like one whatever it is called."""
    directories = resolver.directories
    files = descriptions(directory, config, directories)
    graph = IncludeGraph([*files, *_lookalikes(directory, config, resolver)], resolver)
    return EntryPoints(graph, launch_files(directory, config, directories))


def _lookalikes(directory: str, config: Config, resolver: Resolver) -> Iterator[str]:
    """The files with the root ``<robot>`` whose suffix is not that of a description."""
    found = filter(_may_be_lookalike, resolver.directories.walk(directory))
    for path in filter(resolver.admits, islice(found, MAX_FILES)):
        head = without_comments(read_head(path, _HEAD)).removeprefix(_MARK)
        if ROOT.match(head) and not matches(config.relative(path), config.exclude):
            yield path


def _may_be_lookalike(path: str) -> bool:
    suffix = os.path.splitext(path)[1].lower()
    return not (suffix in _NO_ROBOTS or suffix in _INCLUDED or is_launch(path))


def launch_files(directory: str, config: Config, directories: Directories) -> Iterator[str]:
    """The launch files below a directory that can be read, sorted."""
    return (path for path in directories.walk(directory) if _is_readable_launch(path, config))


def _is_readable_launch(path: str, config: Config) -> bool:
    if not is_launch(path) or matches(config.relative(path), config.exclude):
        return False
    return disk.is_file(path) and os.access(path, os.R_OK)


def affected(files: Iterable[str], config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points that some changed files are part of, each once, and changed launch files.

    A description is part of the robots whose includes lead to it, wherever in the repository
    they are. Any other file (a mesh, a YAML file, a launch file) stands for every robot of its
    package, and for those elsewhere that name it: which of them use it is known only after
    expansion. Hidden files, such as the settings of a CI server, are part of no robot.
    """
    changed: dict[str, list[str]] = {}
    for file in map(os.path.abspath, files):
        directory = _repository(file, resolver)
        if f"{os.sep}." not in file[len(directory.rstrip(os.sep)) :]:
            changed.setdefault(directory, []).append(file)
    robots: list[RobotEntry] = []
    libraries: list[str] = []
    launches: list[str] = []
    for directory, here in sorted(changed.items()):
        if resolver.packages.is_shared(directory):  # all of it would be walked: of home, or /tmp
            files = [file for file in here if file.lower().endswith(_INCLUDED)]
            entry_points = EntryPoints(IncludeGraph(files, resolver), ())
        else:
            entry_points = _entry_points(directory, config, resolver)
        found, graph = entry_points.contents(), entry_points.graph
        known = [robot for robot in config.robots if is_within(robot.file, directory)]
        # A configuration names the robots below itself; it knows nothing of those in siblings.
        others = [r for r in found.robots if not (known and is_within(r.file, config.directory))]
        robots += sorted(
            (
                robot
                for robot in (*known, *others)
                if any(graph.concerns(robot.file, file) for file in here)
            ),
            key=lambda robot: robot[:2],
        )
        libraries += [path for path in found.libraries if path in here]
        launches += [path for path in here if _is_readable_launch(path, config)]
    return DirectoryContents(tuple(robots), tuple(libraries), launches=tuple(launches))


def _repository(file: str, resolver: Resolver) -> str:
    """The directory in which a file is shared: its repository, else its package, else its own."""
    directory = os.path.dirname(file)
    while not disk.is_directory(directory):  # the file is gone, with its directory
        directory = os.path.dirname(directory)
    for above in upwards(directory):
        if disk.exists(os.path.join(above, ".git")) and not resolver.packages.is_shared(above):
            return above
    package = resolver.packages.enclosing(os.path.join(directory, "x"))
    return package[1] if package else directory


def descriptions(directory: str, config: Config, directories: Directories) -> Iterator[str]:
    """The files below a directory that may be descriptions or parts of them, sorted."""
    if not disk.is_directory(directory):
        raise UnreadableFile(f"{directory}: no such directory")
    count = 0
    for path in directories.walk(directory):
        is_part = path.lower().endswith(_INCLUDED)
        is_chosen = is_part and not matches(config.relative(path), config.exclude)
        # A broken link is reported; a pipe or a device may never end.
        if is_chosen and (disk.is_file(path) or not disk.exists(path)):
            count += 1
            if count > MAX_FILES:
                raise UnreadableFile(f"{directory}: more than {MAX_FILES} descriptions")
            yield path
