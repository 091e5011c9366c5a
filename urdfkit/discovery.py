"""Which files of a folder are robots: its entry points, by the include graph.

A xacro that another file includes is checked through that file, not alone. Includes are read from
the text, without expanding anything, so that a change of one file leads to the robots it is part
of in a few milliseconds per file.
"""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from typing import NamedTuple

from urdfkit.config import Config, Robot, matches
from urdfkit.errors import UnreadableFile
from urdfkit.resolve import Resolver
from urdfkit.source import Source

#: Files of one folder that are looked at.
MAX_FILES = 20_000

SUFFIXES = (".urdf", ".xacro")
_PASSED_OVER = frozenset(("build", "install", "log", "devel", "node_modules", "__pycache__"))
_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_INCLUDE = re.compile(rb"""<xacro:include\b[^>]*?\bfilename\s*=\s*["']([^"']+)["']""")
_ROBOT = re.compile(rb"<robot[\s>]")
_FIND = re.compile(r"\$\(find\s+([\w-]+)\s*\)")
_EXPRESSION = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)")
_CONTENT = re.compile(rb"<(link|joint|include)\b|<xacro:(?!include|macro|property|arg|if|unless|insert)\w")


class Found(NamedTuple):
    """What a folder holds.

    Attributes:
        robots: the entry points, sorted by path.
        libraries: files of macros, properties or materials that no file includes.
    """

    robots: tuple[Robot, ...]
    libraries: tuple[str, ...]


def discover(folder: str, config: Config, resolver: Resolver) -> Found:
    """The entry points of a folder: those of the configuration in it, else by the includes.

    Raises:
        UnreadableFile: the folder cannot be read, or holds no description.
    """
    inside = os.path.join(os.path.abspath(folder), "")
    configured = tuple(robot for robot in config.robots if robot.file.startswith(inside))
    if configured:
        return Found(configured, ())
    graph = IncludeGraph(_descriptions(folder, config), resolver)
    robots, libraries = [], []
    for path in graph.roots():
        if graph.is_library(path):
            libraries.append(path)
        else:
            robots.append(Robot(path, "", {}))
    if not robots and not libraries:
        raise UnreadableFile(f"{folder}: no .urdf and no .xacro with a <robot> in it")
    return Found(tuple(robots), tuple(libraries))


def affected(files: Iterable[str], config: Config, resolver: Resolver) -> Found:
    """The entry points whose include closure holds some changed files, each once.

    A file that is no description (a mesh, a YAML file, a launch file) stands for every robot of
    its package: which of them use it is known only after expansion.
    """
    changed = [os.path.abspath(file) for file in files]
    folders = {_package_folder(file, resolver) for file in changed}
    robots: dict[tuple[str, str], Robot] = {}
    libraries: dict[str, None] = {}
    for folder in sorted(folders):
        found = discover(folder, config, resolver)
        graph = IncludeGraph(_descriptions(folder, config), resolver)
        here = {file for file in changed if _package_folder(file, resolver) == folder}
        for robot in found.robots:
            closure = graph.closure(os.path.realpath(robot.file))
            if any(os.path.realpath(f) in closure or not f.endswith(SUFFIXES) for f in here):
                robots.setdefault((robot.file, robot.name), robot)
        libraries.update(dict.fromkeys(path for path in found.libraries if path in here))
    return Found(tuple(robots.values()), tuple(libraries))


def _package_folder(file: str, resolver: Resolver) -> str:
    package = resolver.packages.enclosing(file)
    return package[1] if package else os.path.dirname(file)


def _descriptions(folder: str, config: Config) -> Iterator[str]:
    """The URDF and xacro files below a folder, sorted."""
    if not os.path.isdir(folder):
        raise UnreadableFile(f"{folder}: no such folder")
    count = 0
    for parent, folders, files in os.walk(folder):
        folders[:] = sorted(
            name for name in folders if not name.startswith(".") and name not in _PASSED_OVER
        )
        for name in sorted(files):
            path = os.path.join(parent, name)
            if _is_description(name) and not matches(config.relative(path), config.exclude):
                count += 1
                if count > MAX_FILES:
                    raise UnreadableFile(f"{folder}: more than {MAX_FILES} descriptions")
                yield path


def _is_description(name: str) -> bool:
    return name.endswith(SUFFIXES) and not name.endswith((".srdf.xacro", ".sdf.xacro"))


class IncludeGraph:
    """Who includes whom among some files."""

    def __init__(self, files: Iterable[str], resolver: Resolver) -> None:
        self.resolver = resolver
        self._sources: dict[str, Source] = {}
        self._names: dict[str, str] = {}
        for path in files:
            try:
                source = Source.read(path)
            except UnreadableFile:
                continue  # a dangling link, or no permission: its check will say so
            if _ROBOT.search(source.data):
                real = os.path.realpath(path)
                self._sources[real] = source
                self._names[real] = path
        self.includes = {path: self._includes(path) for path in self._sources}

    def _includes(self, path: str) -> frozenset[str]:
        source = self._sources[path]
        if b"xacro:include" not in source.data:
            return frozenset()
        data = _COMMENT.sub(b"", source.data)
        found: set[str] = set()
        for name in _INCLUDE.findall(data):
            found.update(self._targets(name.decode("utf-8", "replace"), source.path))
        return frozenset(found - {path})

    def _targets(self, name: str, near: str) -> Iterator[str]:
        """The files that an include may mean; by their name where its folder is an expression."""
        text = _FIND.sub(lambda match: self._package(match.group(1), near), name)
        text = text.replace("$(dirname)", os.path.dirname(os.path.abspath(near)))
        if "$" not in text and not set("*?[") & set(text):
            path = os.path.join(os.path.dirname(os.path.abspath(near)), text)
            yield os.path.realpath(self._existing(path))
            return
        yield from self._alike(os.path.basename(_EXPRESSION.sub("*", text)), near)

    def _alike(self, pattern: str, near: str) -> Iterator[str]:
        """The files of a package that a name with expressions in it, as ``*``, may mean."""
        words = [re.escape(word) for word in pattern.split("*")]
        if not any(os.path.splitext(word)[0].strip(".\\") for word in words):
            return  # nothing but an expression: it may mean any file
        folder = os.path.join(os.path.realpath(_package_folder(near, self.resolver)), "")
        for path in self._sources:
            if path.startswith(folder) and re.fullmatch(".*".join(words), os.path.basename(path)):
                yield path

    def _existing(self, path: str) -> str:
        return path if os.path.exists(path) else self.resolver.installed(path) or path

    def _package(self, name: str, near: str) -> str:
        from urdfkit.errors import PackageNotFound

        try:
            return self.resolver.package(name, near)
        except PackageNotFound:
            return f"$(find {name})"

    def roots(self) -> list[str]:
        """The files that no other file includes, as they were named."""
        included = {target for targets in self.includes.values() for target in targets}
        return [self._names[path] for path in self._sources if path not in included]

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
        data = _COMMENT.sub(b"", self._sources[os.path.realpath(path)].data)
        outside = re.sub(rb"<xacro:macro\b.*?</xacro:macro\s*>", b"", data, flags=re.DOTALL)
        return not _CONTENT.search(outside) and not _INCLUDE.search(outside)
