"""The graph of xacro includes, read from the texts without expansion."""

import os
import re
from collections.abc import Iterable, Iterator
from fnmatch import fnmatchcase
from functools import cache

from urdfkit.core import disk
from urdfkit.core.suggest import is_typo
from urdfkit.text.comments import comments, without_comments
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.srdf_files import are_for

SUFFIXES = (".urdf", ".xacro")
#: Suffixes of xacros that do not describe a robot.
OTHER_MODELS = (".srdf.xacro", ".sdf.xacro")
_DISABLED = rb"""xacro:include\b(?:(?!xacro:)[^<>])*?\bfilename\s*=\s*["']([^"']+)["']"""
INCLUDE = b"<" + _DISABLED
ROBOT = rb"<robot[\s>]"
_ROOT_TAG = rb"\s*(?:<[?!][^>]*>\s*)*<(\w+)"
_EXPRESSION = r"\$\{[^${}]*\}|\$\([^$()]*\)"


def _is_broken_robot(path: str, data: bytes) -> bool:
    """True for a URDF without its root, such as a Git LFS pointer, or a xacro with a misspelt one.

    Xacros may also be fragments with another root, such as ``<root>``.
    """
    name = path.lower()
    if not name.endswith(".urdf.xacro"):
        return name.endswith(".urdf")
    root = re.match(_ROOT_TAG, without_comments(data))
    tag = root.group(1).decode().lower() if root else ""
    return tag != "root" and is_typo(tag, "robot")


class IncludeGraph:
    """The graph of the includes among some files."""

    def __init__(self, files: Iterable[str], resolver: Resolver) -> None:
        self.resolver = resolver
        self._has_srdf_for = cache(lambda package, robot: are_for(package, robot, resolver))
        #: Texts of the files with an include, by real path. The others, which may be thousands,
        #: are read again when needed.
        self._including: dict[str, bytes] = {}
        #: The given paths of the descriptions, by real path.
        self.names: dict[str, str] = {}
        self.closed: list[str] = []  # paths of descriptions that cannot be read
        for path in files:
            source = resolver.readable(path)
            if source is None:
                self.closed += [path] if is_description(path) else []
                continue
            if re.search(ROBOT, source.data) or _is_broken_robot(path, source.data):
                real = disk.real(path)
                if real not in self.names or is_description(path):  # prefers links with a suffix
                    self.names[real] = path
                if b"xacro:include" in source.data:
                    self._including[real] = source.data
        #: The real paths of the files that each xacro includes, by its real path.
        self.includes = {path: self._includes(path) for path in self._including}

    def text(self, path: str) -> bytes:
        """The text of a description, by its real path."""
        return self._including.get(path) or self.resolver.read(self.names[path]).data

    def _includes(self, path: str) -> frozenset[str]:
        return self.targets(re.findall(INCLUDE, without_comments(self._including[path])), path)

    def disabled(self) -> set[str]:
        """The files of includes in comments."""
        files: set[str] = set()
        for path, data in self._including.items():
            text = b"".join(comment[1] for comment in comments(data))
            files |= self.targets(re.findall(_DISABLED, text), path)
        return files

    def targets(self, names: Iterable[bytes], path: str) -> frozenset[str]:
        """The files that the includes of a file may refer to."""
        files: set[str] = set()
        for name in names:
            files.update(self._candidates(name.decode("utf-8", "replace"), self.names[path]))
        return frozenset(files - {path})

    def _candidates(self, name: str, near: str) -> Iterator[str]:
        """The files that an include may refer to; by name if its directory is an expression."""
        text = re.sub(FIND, lambda match: self._package(match.group(1), near), name)
        text = text.replace("$(dirname)", os.path.dirname(os.path.abspath(near)))
        if "$" not in text and not set("*?[") & set(text):
            path = os.path.join(os.path.dirname(os.path.abspath(near)), text)
            if "\0" not in path:  # invalid in paths
                found = path if disk.exists(path) else self.resolver.installed(path)
                yield disk.real(found or path)
            return
        yield from self._alike(os.path.basename(re.sub(_EXPRESSION, "*", text)), near)

    def _alike(self, pattern: str, near: str) -> Iterator[str]:
        """The files of a package that a pattern may mean; ``*`` stands for expressions, too."""
        words = [os.path.splitext(word)[0].strip(".") for word in pattern.split("*")]
        if not any(words) or pattern == "*.urdf":
            return  # nothing but an expression: it may mean any file, or any whole robot
        directory = os.path.join(disk.real(_package_directory(near, self.resolver)), "")
        for path in self.names:
            if path.startswith(directory) and fnmatchcase(os.path.basename(path), pattern):
                yield path

    def _package(self, name: str, near: str) -> str:
        from urdfkit.errors import PackageNotFound

        try:
            return self.resolver.package(name, near)
        except PackageNotFound:
            return f"$(find {name})"

    def concerns(self, root: str, file: str) -> bool:
        """True if a robot may use a changed file."""
        closure = self.closure(disk.real(root))
        if disk.real(file) in closure:
            return True
        if file.lower().endswith(SUFFIXES):
            return False
        packages = self.resolver.packages
        package = packages.enclosing(file)
        if package is not None and (
            package == packages.enclosing(root) or self._has_srdf_for(package[1], root)
        ):
            return True
        name = os.path.basename(file).encode("utf-8", "surrogateescape")
        return any(name in self.text(path) for path in closure if path in self.names)

    def closure(self, path: str) -> set[str]:
        """A file and all files that it includes, directly or not."""
        files = {path}
        queue = [path]
        while queue:
            for target in self.includes.get(queue.pop(), ()):
                if target not in files:
                    files.add(target)
                    queue.append(target)
        return files


def is_description(name: str) -> bool:
    """True for file names of URDF and xacro files."""
    name = name.lower()  # SolidWorks writes .URDF
    return name.endswith(SUFFIXES) and not name.endswith(OTHER_MODELS)


def _package_directory(file: str, resolver: Resolver) -> str:
    package = resolver.packages.enclosing(file)
    return package[1] if package else os.path.dirname(file)
