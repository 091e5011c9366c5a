"""Discovery of the robots in a directory: the entry points of the include graph.

A xacro that another file includes is checked as part of that file, not alone. Includes are read
from the text without expansion, so that the robots that use a changed file are found in a few
milliseconds per file.
"""

import os
import re
from collections.abc import Iterable, Iterator
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config, RobotEntry, matches
from urdfkit.lint.entry_points import ROOT, DirectoryContents, EntryPoints
from urdfkit.lint.include_graph import SUFFIXES, IncludeGraph
from urdfkit.text.comments import without_comments
from urdfkit.text.file_kinds import generates_launch, has_launch_name, is_launch
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.resolve import Resolver

#: Most files of one directory that are read.
MAX_FILES = 20_000

#: Suffixes of files that descriptions include.
_INCLUDED = (*SUFFIXES, ".gazebo", ".trans", ".xml")
#: Suffixes of files that do not contain a robot; files with any other suffix are read.
_NO_ROBOTS = frozenset(
    ".bmp .bt .c .cc .cfg .cmake .cpp .csv .dae .db3 .gif .glb .gltf .gz .h .hpp .htm .html .ipynb "
    ".jpeg .jpg .js .json .launch .lua .material .mcap .md .mp4 .msg .mtl .obj .pcd .pdf .pgm .ply "
    ".png .py .rst .rviz .sdf .sh .srdf .srv .step .stl .stp .svg .tga .toml .ttf .txt .usd .webp "
    ".world .yaml .yml .zip".split()
)
#: Suffixes of files that programs of launch files read.
_LAUNCHED = (".lua", ".rviz", ".sdf", ".world", ".yaml", ".yml")
#: Number of bytes at the start of a file that are searched for the root element.
_HEAD = 4096
_MARK = b"\xef\xbb\xbf"
#: A placeholder in a template of MoveIt's setup assistant.
_PLACEHOLDER = re.compile(rb"\[[A-Z]+(?:_[A-Z]+)+\]")
_MAX_TEMPLATE = 65_536
#: A value that a program replaces: ``$name$``, ``{{ name }}`` or ``@NAME@``.
_REPLACED = re.compile(rb"""=\s*["'](?:\$[A-Za-z_]\w*\$|\{\{[^{}"']*\}\}|@[A-Za-z_]\w*@)["']""")
#: A word in capitals for a number, in a file that is called a template: ``size="DIM0 DIM1"``.
_IN_CAPITALS = re.compile(
    rb"""\b(?:size|xyz|scale|radius|length|value)\s*=\s*["'][^"']*\b[A-Z]{3,}\d*\b"""
)
_TEMPLATE = "is a template: a program replaces its values"
#: A robot in a directory of tests whose name says that it is wrong.
_WRONG_ON_PURPOSE = (
    r"(?i)(?:^|/)tests?/(?:.*/)?[^/]*(?:fail|invalid|broken|malformed|corrupt)[^/]*$"
)
_OF_TEST = "is for tests, and wrong on purpose: its name says so"
_NOT_CONFIGURED = "no [[robot]] in the configuration for it"


def discover(directory: str, config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points of a directory: from the configuration, else from the include graph.

    Raises:
        UnreadableFile: the directory cannot be read, or contains no description.
    """
    entry_points = _entry_points(directory, config, resolver)
    contents = entry_points.contents()
    top = os.path.abspath(directory)
    configured = tuple(robot for robot in config.robots if is_within(robot.file, top))
    if configured:
        named = {disk.real(robot.file) for robot in configured}
        reached = {path for robot in named for path in entry_points.graph.closure(robot)}
        left = [robot.file for robot in contents.robots if disk.real(robot.file) not in reached]
        return DirectoryContents(configured, (), others=dict.fromkeys(left, _NOT_CONFIGURED))
    contents = _without_broken_tests(_without_templates(contents), top)
    if not any(contents):
        excluded = f", not counting what 'exclude' in {config.path} names" if config.exclude else ""
        raise UnreadableFile(
            f"{directory}: contains no .urdf, no .xacro with a <robot> and no launch file{excluded}"
        )
    return contents


def _without_templates(contents: DirectoryContents) -> DirectoryContents:
    """The contents without robots whose values a program writes, which are named as skipped."""
    templates = {robot.file for robot in contents.robots if _is_robot_template(robot.file)}
    return contents._replace(
        robots=tuple(robot for robot in contents.robots if robot.file not in templates),
        others={**contents.others, **dict.fromkeys(sorted(templates), _TEMPLATE)},
    )


def _without_broken_tests(contents: DirectoryContents, top: str) -> DirectoryContents:
    """The contents without robots of tests that are wrong on purpose, if there are others."""
    wrong = {
        robot.file
        for robot in contents.robots
        if re.search(_WRONG_ON_PURPOSE, os.path.relpath(robot.file, top).replace(os.sep, "/"))
    }
    robots = tuple(robot for robot in contents.robots if robot.file not in wrong)
    if not robots:
        return contents
    others = {**contents.others, **dict.fromkeys(sorted(wrong), _OF_TEST)}
    return contents._replace(robots=robots, others=others)


def _is_robot_template(path: str) -> bool:
    """True for a robot whose values a program writes."""
    text = without_comments(read_head(path, _MAX_TEMPLATE))
    is_called_so = "template" in os.path.basename(path).lower()
    return bool(_REPLACED.search(text) or (is_called_so and _IN_CAPITALS.search(text)))


def _entry_points(directory: str, config: Config, resolver: Resolver) -> EntryPoints:
    """The entry points of a directory, including robots with an unusual suffix."""
    directories = resolver.directories
    files = descriptions(directory, config, directories)
    graph = IncludeGraph([*files, *_lookalikes(directory, config, resolver)], resolver)
    return EntryPoints(graph, launch_files(directory, config, directories))


def _lookalikes(directory: str, config: Config, resolver: Resolver) -> Iterator[str]:
    """The files with the root ``<robot>`` whose suffix is not that of a description."""
    paths = filter(_may_be_lookalike, resolver.directories.walk(directory))
    for path in filter(resolver.admits, islice(paths, MAX_FILES)):
        head = without_comments(read_head(path, _HEAD)).removeprefix(_MARK)
        if ROOT.match(head) and not matches(config.relative(path), config.exclude):
            yield path


def _may_be_lookalike(path: str) -> bool:
    suffix = os.path.splitext(path)[1].lower()
    return not (suffix in _NO_ROBOTS or suffix in _INCLUDED or is_launch(path))


def launch_files(directory: str, config: Config, directories: Directories) -> Iterator[str]:
    """The readable launch files below a directory, sorted."""
    return (path for path in directories.walk(directory) if _is_readable_launch(path, config))


def _is_readable_launch(path: str, config: Config) -> bool:
    if not is_launch(path) or matches(config.relative(path), config.exclude):
        return False
    is_readable = disk.is_file(path) and os.access(path, os.R_OK)
    if not is_readable or _is_template(path):
        return False
    return has_launch_name(path) or generates_launch(read_head(path))


def _is_template(path: str) -> bool:
    """True for a file in a directory of templates, from which a program writes another file.

    A placeholder in one launch file is enough for those next to it: they include what is written.
    """
    directory = os.path.dirname(path)
    if f"templates{os.sep}" not in f"{directory}{os.sep}":
        return False
    siblings = (os.path.join(directory, name) for name in disk.names_or_empty(directory))
    files = filter(is_launch, siblings) if is_launch(path) else (path,)
    return any(_PLACEHOLDER.search(read_head(file, _MAX_TEMPLATE)) for file in files)


def srdf_files_below(directory: str, config: Config, resolver: Resolver) -> Iterator[str]:
    """The readable SRDFs below a directory, sorted."""
    for path in resolver.directories.walk(directory):
        is_chosen = path.endswith(".srdf") and not matches(config.relative(path), config.exclude)
        if is_chosen and resolver.admits(path) and not _is_template(path):
            yield path


def affected(files: Iterable[str], config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points that use changed files, and the launch files that changed or name one.

    A robot uses the descriptions that it includes, directly or not, anywhere in the repository.
    Any other file (mesh, YAML file, launch file) is assumed to be used by every robot of its
    package, and by robots elsewhere that contain its name, as actual uses are known only after
    expansion. Hidden files, such as the settings of a CI server, are used by no robot.
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
        if resolver.packages.is_shared(directory):  # too large to walk, such as home or /tmp
            files = [file for file in here if file.lower().endswith(_INCLUDED)]
            entry_points = EntryPoints(IncludeGraph(files, resolver), ())
        else:
            entry_points = _entry_points(directory, config, resolver)
        contents, concerns = entry_points.contents(), entry_points.graph.concerns
        uses = (
            robot
            for robot in _robots(contents, directory, config)
            if any(concerns(robot.file, file) for file in here)
        )
        robots += sorted(uses, key=lambda robot: robot[:2])
        libraries += [path for path in contents.libraries if path in here]
        launches += _launches(directory, here, config, resolver)
    return DirectoryContents(tuple(robots), tuple(libraries), launches=tuple(launches))


def _launches(
    directory: str, files: list[str], config: Config, resolver: Resolver
) -> Iterator[str]:
    """The launch files among some files, and those that name another one of them."""
    yield from (path for path in files if _is_readable_launch(path, config))
    names = [os.path.basename(path).encode() for path in files if path.endswith(_LAUNCHED)]
    if not names or resolver.packages.is_shared(directory):
        return
    for path in launch_files(directory, config, resolver.directories):
        head = read_head(path)
        if path not in files and any(name in head for name in names):
            yield path


def _robots(contents: DirectoryContents, directory: str, config: Config) -> tuple[RobotEntry, ...]:
    """The robots of a configuration below a directory, and those that it does not list."""
    listed = [robot for robot in config.robots if is_within(robot.file, directory)]
    if not listed:
        return contents.robots
    # A configuration lists the robots below its directory only.
    others = [robot for robot in contents.robots if not is_within(robot.file, config.directory)]
    return (*listed, *others)


def _repository(file: str, resolver: Resolver) -> str:
    """The repository of a file, else its package, else its directory."""
    directory = os.path.dirname(file)
    while not disk.is_directory(directory):  # the directory was removed
        directory = os.path.dirname(directory)
    for above in upwards(directory):
        if disk.exists(os.path.join(above, ".git")) and not resolver.packages.is_shared(above):
            return above
    package = resolver.packages.enclosing(os.path.join(directory, "x"))
    return package[1] if package else directory


def descriptions(directory: str, config: Config, directories: Directories) -> Iterator[str]:
    """The files below a directory that may be descriptions or parts of them, sorted."""
    if not disk.is_directory(directory):
        defect = "is a file, not a directory" if disk.exists(directory) else "no such directory"
        raise UnreadableFile(f"{directory}: {defect}")
    count = 0
    for path in directories.walk(directory):
        is_part = path.lower().endswith(_INCLUDED)
        is_chosen = is_part and not matches(config.relative(path), config.exclude)
        # Broken links are reported; pipes and devices may be endless.
        if is_chosen and (disk.is_file(path) or not disk.exists(path)) and not _is_template(path):
            count += 1
            if count > MAX_FILES:
                raise UnreadableFile(f"{directory}: more than {MAX_FILES} descriptions")
            yield path
