"""Which files of a directory are robots: its entry points, by the include graph.

A xacro that another file includes is checked through that file, not alone. Includes are read from
the text, without expanding anything, so that a change of one file leads to the robots it is part
of in a few milliseconds per file.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping
from fnmatch import fnmatchcase
from itertools import islice

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config, RobotEntry, matches
from urdfkit.text.comments import comments, without_comments
from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver

#: Files of one directory that are looked at.
MAX_FILES = 20_000

SUFFIXES = (".urdf", ".xacro")
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
#: A macro without an end goes on to that of the file.
_MACRO = re.compile(rb"<xacro:macro\b.*?(?:</xacro:macro\s*>|\Z)", re.DOTALL)
_INCLUDE = re.compile(rb"""<xacro:include\b[^<>]*?\bfilename\s*=\s*["']([^"']+)["']""")
_DISABLED = re.compile(rb"""xacro:include\b[^<>]*?\bfilename\s*=\s*["']([^"']+)["']""")
_ROBOT = re.compile(rb"<robot[\s>]")
_ROOT = re.compile(rb"\s*(?:<[?!][^>]*>\s*)*<robot[\s>]")
_LINK = re.compile(rb"<link[\s>]")
_LINK_NAME = re.compile(rb"""<link\b[^<>]*?\bname\s*=\s*["']([^"']+)["']""")
_PARENT = re.compile(rb"""<parent\b[^<>]*?\blink\s*=\s*["']([^"']+)["']""")
_NAMED = re.compile(rb"""<robot\b[^<>]*\sname\s*=\s*["'][^"'$]""")
_NAMELESS = re.compile(rb"""<robot\b(?![^<>]*\sname\s*=\s*["'][^"'])""")
_ARGUMENT = re.compile(rb"\$\(arg\s+([\w-]+)\s*\)")
_DEFAULT = re.compile(rb"<xacro:arg\b(?=[^<>]*\sdefault\s*=)[^<>]*?\sname\s*=\s*[\"']([^\"']+)")
_MARK = b"\xef\xbb\xbf"
_PART = "a part of a robot that no file includes"
_NOT_CONFIGURED = "no [[robot]] in the configuration for it"
_UNUSUAL = "has the root <robot>, but an unusual suffix, and no launch file references it"
_EXPRESSION = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)")
_CONTENT = re.compile(
    rb"<(link|joint|include)\b|<xacro:(?!include|macro|property|arg|if|unless|insert)\w"
)


class DirectoryContents(Record):
    """What a directory holds.

    Attributes:
        robots: the entry points, sorted by path.
        libraries: files of macros, properties or materials that no file includes.
        closed: descriptions that cannot be opened: links that lead nowhere, no permission.
        others: files that look like robots and are none of these, by why they are left out.
    """

    robots: tuple[RobotEntry, ...]
    libraries: tuple[str, ...]
    closed: tuple[str, ...] = ()
    others: Mapping[str, str] = {}


def discover(directory: str, config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points of a directory: those of the configuration in it, else by the includes.

    Raises:
        UnreadableFile: the directory cannot be read, or holds no description.
    """
    graph = _graph(directory, config, resolver)
    found = graph.entry_points()
    configured = tuple(robot for robot in config.robots if _is_within(robot.file, directory))
    if configured:
        named = {disk.real(robot.file) for robot in configured}
        reached = {path for robot in named for path in graph.closure(robot)}
        left = [one.file for one in found.robots if disk.real(one.file) not in reached]
        return DirectoryContents(configured, (), others=dict.fromkeys(left, _NOT_CONFIGURED))
    if not any(found):
        raise UnreadableFile(
            f"{directory}: contains no .urdf, no .xacro with a <robot> and no launch file"
        )
    return found


def _graph(directory: str, config: Config, resolver: Resolver) -> IncludeGraph:
    """The descriptions of a directory, and what looks like one whatever it is called."""
    directories = resolver.directories
    files = [
        *descriptions(directory, config, directories),
        *_lookalikes(directory, config, resolver),
    ]
    return IncludeGraph(files, resolver, launch_files(directory, config, directories))


def _lookalikes(directory: str, config: Config, resolver: Resolver) -> Iterator[str]:
    """The files with the root ``<robot>`` whose suffix is not that of a description."""
    found = filter(_may_be_lookalike, resolver.directories.walk(directory))
    for path in filter(resolver.admits, islice(found, MAX_FILES)):
        head = without_comments(read_head(path, _HEAD)).removeprefix(_MARK)
        if _ROOT.match(head) and not matches(config.relative(path), config.exclude):
            yield path


def _may_be_lookalike(path: str) -> bool:
    suffix = os.path.splitext(path)[1].lower()
    return not (suffix in _NO_ROBOTS or suffix in _INCLUDED or is_launch(path))


def launch_files(directory: str, config: Config, directories: Directories) -> Iterator[str]:
    """The launch files below a directory that can be read, sorted."""
    for path in filter(is_launch, directories.walk(directory)):
        is_chosen = not matches(config.relative(path), config.exclude)
        if is_chosen and disk.is_file(path) and os.access(path, os.R_OK):
            yield path


def affected(files: Iterable[str], config: Config, resolver: Resolver) -> DirectoryContents:
    """The entry points that some changed files are part of, each once.

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
    for directory, here in sorted(changed.items()):
        graph = _graph(directory, config, resolver)
        found = graph.entry_points()
        known = [robot for robot in config.robots if _is_within(robot.file, directory)]
        # A configuration names the robots below itself; it knows nothing of those in siblings.
        others = [r for r in found.robots if not (known and _is_within(r.file, config.directory))]
        robots += sorted(
            (
                robot
                for robot in (*known, *others)
                if any(graph.concerns(robot.file, file) for file in here)
            ),
            key=lambda robot: robot[:2],
        )
        libraries += [path for path in found.libraries if path in here]
    return DirectoryContents(tuple(robots), tuple(libraries))


def _repository(file: str, resolver: Resolver) -> str:
    """The directory in which a file is shared: its repository, else its package, else its own."""
    directory = os.path.dirname(file)
    while not disk.is_directory(directory):  # the file is gone, with its directory
        directory = os.path.dirname(directory)
    above = own = directory
    while not disk.exists(os.path.join(above, ".git")):
        above, below = os.path.dirname(above), above
        if above == below:
            package = resolver.packages.enclosing(os.path.join(own, "x"))
            return package[1] if package else own
    return above


def _is_within(path: str, directory: str) -> bool:
    return path.startswith(os.path.join(os.path.abspath(directory), ""))


def _package_directory(file: str, resolver: Resolver) -> str:
    package = resolver.packages.enclosing(file)
    return package[1] if package else os.path.dirname(file)


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


def _is_description(name: str) -> bool:
    name = name.lower()  # SolidWorks writes .URDF
    return name.endswith(SUFFIXES) and not name.endswith((".srdf.xacro", ".sdf.xacro"))


class IncludeGraph:
    """Who includes whom among some files.

    Args:
        files: descriptions and parts of them.
        resolver: finds packages, and reads files.
        launches: paths of launch files; what they name is a robot, whatever its suffix.
    """

    def __init__(
        self, files: Iterable[str], resolver: Resolver, launches: Iterable[str] = ()
    ) -> None:
        self.resolver = resolver
        self._launches = launches
        #: Of thousands of plain URDFs none is kept: hardly a question is about them.
        self._xacros: dict[str, bytes] = {}
        self._names: dict[str, str] = {}
        self.closed: list[str] = []
        for path in files:
            try:
                source = resolver.read(path)
            except UnreadableFile:
                self.closed += [path] if _is_description(path) else []
                continue
            # A .urdf counts whatever is in it: nothing, a pointer of Git LFS.
            if _ROBOT.search(source.data) or path.lower().endswith(".urdf"):
                real = disk.real(path)
                self._names[real] = path
                if b"xacro" in source.data:
                    self._xacros[real] = source.data
        self.includes = {path: self._includes(path) for path in self._xacros}

    def _text(self, path: str) -> bytes:
        return self._xacros.get(path) or self.resolver.read(self._names[path]).data

    def _includes(self, path: str) -> frozenset[str]:
        data = self._xacros[path]
        if b"xacro:include" not in data:
            return frozenset()
        return self._named(_INCLUDE.findall(without_comments(data)), path)

    def _disabled(self) -> set[str]:
        """The files that only an include in a comment names."""
        found: set[str] = set()
        for path, data in self._xacros.items():
            if b"<!--" in data and b"xacro:include" in data:
                text = b"".join(comment[1] for comment in comments(data))
                found |= self._named(_DISABLED.findall(text), path)
        return found

    def _named(self, names: Iterable[bytes], path: str) -> frozenset[str]:
        """The files that the includes of a file may mean."""
        found: set[str] = set()
        for name in names:
            found.update(self._targets(name.decode("utf-8", "replace"), self._names[path]))
        return frozenset(found - {path})

    def _targets(self, name: str, near: str) -> Iterator[str]:
        """The files that an include may mean; by name where its directory is an expression."""
        text = re.sub(FIND, lambda match: self._package(match.group(1), near), name)
        text = text.replace("$(dirname)", os.path.dirname(os.path.abspath(near)))
        if "$" not in text and not set("*?[") & set(text):
            path = os.path.join(os.path.dirname(os.path.abspath(near)), text)
            if "\0" not in path:  # which no file has in its name
                yield disk.real(self._existing(path))
            return
        yield from self._alike(os.path.basename(_EXPRESSION.sub("*", text)), near)

    def _alike(self, pattern: str, near: str) -> Iterator[str]:
        """The files of a package that a pattern may mean; ``*`` stands for expressions, too."""
        if not any(os.path.splitext(word)[0].strip(".") for word in pattern.split("*")):
            return  # nothing but an expression: it may mean any file
        directory = os.path.join(disk.real(_package_directory(near, self.resolver)), "")
        for path in self._names:
            if path.startswith(directory) and fnmatchcase(os.path.basename(path), pattern):
                yield path

    def _existing(self, path: str) -> str:
        return path if disk.exists(path) else self.resolver.installed(path) or path

    def _package(self, name: str, near: str) -> str:
        from urdfkit.errors import PackageNotFound

        try:
            return self.resolver.package(name, near)
        except PackageNotFound:
            return f"$(find {name})"

    def entry_points(self) -> DirectoryContents:
        """The descriptions that no other file includes, and the libraries among them.

        Where files include one another in a ring, one of them.
        """
        included = {target for targets in self.includes.values() for target in targets}
        roots = [
            name
            for path, name in self._names.items()
            if path not in included and _is_description(name)
        ]
        roots += self._in_rings(roots)
        libraries = tuple(filter(self.is_library, roots))
        whole = [path for path in roots if path not in libraries]
        parts = self._parts(whole)
        outer = [path for path in whole if path not in parts]
        if not outer:  # what nothing is a part of
            parts, outer = [], whole
        unusual = [
            name
            for path, name in self._names.items()
            if path not in included and not _is_description(name) and self._is_robot(path)
        ]
        started = self._launched(unusual)
        robots = sorted({*outer, *self._within(outer), *started})
        named = tuple(RobotEntry(path, "", {}) for path in robots)
        others = dict.fromkeys((path for path in unusual if path not in started), _UNUSUAL)
        others |= dict.fromkeys(parts, _PART)
        return DirectoryContents(named, libraries, tuple(self.closed), others)

    def _parts(self, roots: Iterable[str]) -> list[str]:
        """The xacros that are not whole: without a name, or with their include commented out."""
        disabled = self._disabled()
        return [
            path
            for path in roots
            if path.lower().endswith(".xacro")
            and (disk.real(path) in disabled or self._is_nameless(path))
            and self._lacks_parent(path)
        ]

    def _is_nameless(self, path: str) -> bool:
        return bool(_NAMELESS.search(without_comments(self._text(disk.real(path)))))

    def _lacks_parent(self, path: str) -> bool:
        """True for a file with a joint whose parent link is certainly in no file it includes.

        Not certain: a link whose name is an expression, and an include that is not found.
        """
        files = self.closure(disk.real(path))
        if not files <= self._names.keys():
            return False
        texts = [without_comments(self._text(file)) for file in files]
        for file, text in zip(files, texts, strict=True):
            if not all(self._named([name], file) for name in _INCLUDE.findall(text)):
                return False
        links = {name for text in texts for name in _LINK_NAME.findall(text)}
        parents = {name for text in texts for name in _PARENT.findall(text)}
        missing = {name for name in parents - links if b"$" not in name}
        return bool(missing) and not any(b"$" in name for name in links)

    def _is_robot(self, path: str) -> bool:
        """True for a file with the root ``<robot>`` that has links outside of macros."""
        data = without_comments(self._text(path))
        return bool(_ROOT.match(data) and _LINK.search(_MACRO.sub(b"", data)))

    def _launched(self, files: list[str]) -> list[str]:
        """The files whose name stands in a launch file."""
        texts = [self.resolver.read(path).data for path in self._launches] if files else []
        return [
            path
            for path in files
            if any(os.fsencode(os.path.basename(path)) in text for text in texts)
        ]

    def _in_rings(self, roots: Iterable[str]) -> Iterator[str]:
        """One file of each ring of includes that no root leads to; its check reports the ring."""
        reached = {path for root in roots for path in self.closure(disk.real(root))}
        for path, name in sorted(self._names.items()):
            if path not in reached and _is_description(name):
                reached |= self.closure(path)
                yield name

    def _within(self, robots: Iterable[str]) -> Iterator[str]:
        """Whole robots that are included by such as cannot be expanded for want of arguments."""
        for robot in map(disk.real, robots):
            closure = self.closure(robot)
            if not self._lacking(closure):
                continue
            for path in closure.intersection(self._names) - {robot}:
                name = self._names[path]
                is_whole = _is_description(name) and _NAMED.search(self._text(path))
                if is_whole and not self.is_library(name) and not self._lacking(self.closure(path)):
                    yield name

    def _lacking(self, files: Iterable[str]) -> set[bytes]:
        """The arguments that some files use together, and none of them gives a default."""
        used: set[bytes] = set()
        known: set[bytes] = set()
        for path in self._names.keys() & files:
            data = without_comments(self._text(path))
            used.update(_ARGUMENT.findall(data))
            known.update(_DEFAULT.findall(data))
        return used - known

    def concerns(self, root: str, file: str) -> bool:
        """True if a changed file may be part of a robot."""
        closure = self.closure(disk.real(root))
        if disk.real(file) in closure:
            return True
        if file.lower().endswith(SUFFIXES):
            return False
        packages = self.resolver.packages
        package = packages.enclosing(file)
        if package is not None and package == packages.enclosing(root):
            return True
        name = os.path.basename(file).encode("utf-8", "surrogateescape")
        return any(name in self._text(path) for path in closure if path in self._names)

    def closure(self, path: str) -> set[str]:
        """A file and everything that it includes, directly or not."""
        found = {path}
        queue = [path]
        while queue:
            for target in self.includes.get(queue.pop(), ()):
                if target not in found:
                    found.add(target)
                    queue.append(target)
        return found

    def is_library(self, path: str) -> bool:
        """True if a file only defines things: outside of macros it makes no link and calls none."""
        if not _ROBOT.search(self._text(disk.real(path))):
            return False
        data = without_comments(self._text(disk.real(path)))
        outside = _MACRO.sub(b"", data)
        return not _CONTENT.search(outside) and not _INCLUDE.search(outside)
