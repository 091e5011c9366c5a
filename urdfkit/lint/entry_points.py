"""Classification of the descriptions in an include graph: robots, libraries and parts."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator, Mapping

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.lint.config import RobotEntry
from urdfkit.lint.include_graph import INCLUDE, ROBOT, SUFFIXES, IncludeGraph, is_description
from urdfkit.text.comments import without_comments

#: A macro; without an end tag it extends to the end of the file.
_MACRO = re.compile(rb"<xacro:macro\b.*?(?:</xacro:macro\s*>|\Z)", re.DOTALL)
_MACRO_NAME = re.compile(rb"""<xacro:macro\b[^<>]*?\sname\s*=\s*["']([^"']+)["']""")
_TAG = re.compile(rb"<(\w+)")
#: Tags of libraries, which a macro may have as its name.
_URDF_TAGS = frozenset((b"robot", b"material", b"gazebo", b"transmission", b"ros2_control"))
_LINK_NAME = re.compile(rb"""<link\b[^<>]*?\bname\s*=\s*["']([^"']+)["']""")
_PARENT = re.compile(rb"""<parent\b[^<>]*?\blink\s*=\s*["']([^"']+)["']""")
_NAMED = re.compile(rb"""<robot\b[^<>]*\sname\s*=\s*["'][^"'$]""")
_NAMELESS = re.compile(rb"""<robot\b(?![^<>]*\sname\s*=\s*["'][^"'])""")
_ARGUMENT = re.compile(rb"\$\(arg\s+([\w-]+)\s*\)")
_DEFAULT = re.compile(rb"<xacro:arg\b(?=[^<>]*\sdefault\s*=)[^<>]*?\sname\s*=\s*[\"']([^\"']+)")
_PART = "a part of a robot that no file includes"
_OF_OTHERS = "defines no link, and no robot that is checked includes it"
_UNUSUAL = "has the root <robot>, but an unusual suffix, and no launch file references it"
_CONTENT = re.compile(
    rb"<(link|joint|include)\b|<xacro:(?!include|macro|property|arg|if|unless|insert)\w"
)
ROOT = re.compile(rb"\s*(?:<[?!][^>]*>\s*)*<robot[\s>]")


class DirectoryContents(Record):
    """The descriptions in a directory."""

    robots: tuple[RobotEntry, ...]  # the entry points, sorted by path
    libraries: tuple[str, ...]  # files of macros, properties or materials that no file includes
    closed: tuple[str, ...] = ()  # descriptions that cannot be opened: broken links, no permission
    others: Mapping[str, str] = {}  # reasons for skipping other files that resemble robots, by path
    launches: tuple[str, ...] = ()  # changed launch files, in the result of `affected`


class EntryPoints:
    """The robots among the descriptions of an include graph.

    Args:
        launches: paths of launch files; files that they reference are robots with any suffix.
    """

    def __init__(self, graph: IncludeGraph, launches: Iterable[str]) -> None:
        self.graph = graph
        self._launches = launches

    def contents(self) -> DirectoryContents:
        """The descriptions that no other file includes, and the libraries among them.

        One file of each include cycle counts as not included.
        """
        included = {target for targets in self.graph.includes.values() for target in targets}
        roots = [
            name
            for path, name in self.graph.names.items()
            if path not in included and is_description(name)
        ]
        unusual = [
            name
            for path, name in self.graph.names.items()
            if path not in included and not name.lower().endswith(SUFFIXES) and self._is_robot(path)
        ]
        started = self._launched(unusual)
        roots += self._in_rings([*roots, *started])
        libraries = tuple(filter(self._is_library, roots))
        whole = [path for path in roots if path not in libraries]
        parts = self._parts(whole)
        outer = [path for path in whole if path not in parts]
        if not outer:  # parts are skipped only if there is another robot
            parts, outer = [], whole
        robots = sorted({*outer, *self._within(outer), *started})
        named = tuple(RobotEntry(path, "", {}) for path in robots)
        others = dict.fromkeys((path for path in unusual if path not in started), _UNUSUAL)
        others |= dict.fromkeys(parts, _PART)
        used = [path for path in libraries if disk.real(path) in included]
        others |= dict.fromkeys(used, _OF_OTHERS)
        unused = tuple(path for path in libraries if path not in used)
        return DirectoryContents(named, unused, tuple(self.graph.closed), others)

    def _parts(self, roots: Iterable[str]) -> list[str]:
        """The xacros that are parts of robots: without a name, or in a commented-out include."""
        disabled = self.graph.disabled()
        return [
            path
            for path in roots
            if path.lower().endswith(".xacro")
            and (disk.real(path) in disabled or self._is_nameless(path))
            and self._lacks_parent(path)
        ]

    def _is_nameless(self, path: str) -> bool:
        return bool(_NAMELESS.search(without_comments(self.graph.text(disk.real(path)))))

    def _lacks_parent(self, path: str) -> bool:
        """True for a file with a joint whose parent link is missing, also in its includes.

        False if it may exist: with an expression as the name of a link, or a missing include.
        """
        files = self.graph.closure(disk.real(path))
        if not files <= self.graph.names.keys():
            return False
        texts = [without_comments(self.graph.text(file)) for file in files]
        for file, text in zip(files, texts, strict=True):
            if not all(self.graph.targets([name], file) for name in re.findall(INCLUDE, text)):
                return False
        links = {name for text in texts for name in _LINK_NAME.findall(text)}
        parents = {name for text in texts for name in _PARENT.findall(text)}
        missing = {name for name in parents - links if b"$" not in name}
        return bool(missing) and not any(b"$" in name for name in links)

    def _is_robot(self, path: str) -> bool:
        """True for a file with the root ``<robot>`` that is not a library."""
        data = without_comments(self.graph.text(path))
        return bool(ROOT.match(data)) and not self._is_library(path)

    def _launched(self, files: list[str]) -> list[str]:
        """The files whose name is in a launch file."""
        texts = [self.graph.resolver.read(path).data for path in self._launches] if files else []
        return [
            path
            for path in files
            if any(os.fsencode(os.path.basename(path)) in text for text in texts)
        ]

    def _in_rings(self, roots: Iterable[str]) -> Iterator[str]:
        """One file of each include cycle outside of the roots; its check reports the cycle."""
        reached = {path for root in roots for path in self.graph.closure(disk.real(root))}
        for path, name in sorted(self.graph.names.items()):
            if path not in reached and is_description(name):
                reached |= self.graph.closure(path)
                yield name

    def _within(self, robots: Iterable[str]) -> Iterator[str]:
        """Complete robots that robots with missing arguments include."""
        for robot in map(disk.real, robots):
            closure = self.graph.closure(robot)
            if not self._lacking(closure):
                continue
            for path in closure.intersection(self.graph.names) - {robot}:
                name = self.graph.names[path]
                is_whole = is_description(name) and _NAMED.search(self.graph.text(path))
                if (
                    is_whole
                    and not self._is_library(name)
                    and not self._lacking(self.graph.closure(path))
                ):
                    yield name

    def _lacking(self, files: Iterable[str]) -> set[bytes]:
        """The arguments that files use and for which none of them has a default."""
        used: set[bytes] = set()
        known: set[bytes] = set()
        for path in self.graph.names.keys() & files:
            data = without_comments(self.graph.text(path))
            used.update(_ARGUMENT.findall(data))
            known.update(_DEFAULT.findall(data))
        return used - known

    def _is_library(self, path: str) -> bool:
        """True for a file with definitions only: no links, joints, includes or macro calls."""
        data = self.graph.text(disk.real(path))
        if not re.search(ROBOT, data):
            return False
        data = without_comments(data)
        outside = _MACRO.sub(b"", data)
        # XAC002 reports calls without the prefix.
        calls = set(_TAG.findall(outside)).intersection(_MACRO_NAME.findall(data)) - _URDF_TAGS
        return not calls and not _CONTENT.search(outside) and not re.search(INCLUDE, outside)
