"""Which xacro includes which file; read from the texts, nothing is expanded."""

import os
import re
from collections.abc import Iterable, Iterator
from fnmatch import fnmatchcase

from urdfkit.core import disk
from urdfkit.errors import UnreadableFile
from urdfkit.text.comments import comments, without_comments
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver

SUFFIXES = (".urdf", ".xacro")
#: Of xacros that describe something else than a robot.
OTHER_MODELS = (".srdf.xacro", ".sdf.xacro")
INCLUDE = re.compile(rb"""<xacro:include\b[^<>]*?\bfilename\s*=\s*["']([^"']+)["']""")
_DISABLED = re.compile(rb"""xacro:include\b[^<>]*?\bfilename\s*=\s*["']([^"']+)["']""")
ROBOT = re.compile(rb"<robot[\s>]")
_EXPRESSION = re.compile(r"\$\{[^}]*\}|\$\([^)]*\)")


class IncludeGraph:
    """Who includes whom among some files."""

    def __init__(self, files: Iterable[str], resolver: Resolver) -> None:
        self.resolver = resolver
        #: Those with an include. Of thousands of others none is kept: the few questions about one
        #: read it again.
        self._including: dict[str, bytes] = {}
        #: The paths of the descriptions among them, as given, by real path.
        self.names: dict[str, str] = {}
        self.closed: list[str] = []  # paths of descriptions that cannot be read
        for path in files:
            try:
                source = resolver.read(path)
            except UnreadableFile:
                self.closed += [path] if is_description(path) else []
                continue
            # A .urdf counts whatever is in it: nothing, a pointer of Git LFS.
            if ROBOT.search(source.data) or path.lower().endswith(".urdf"):
                real = disk.real(path)
                if real not in self.names or is_description(path):  # whose link may be called so
                    self.names[real] = path
                if b"xacro:include" in source.data:
                    self._including[real] = source.data
        #: The real paths of the files that each xacro includes, by its own.
        self.includes = {path: self._includes(path) for path in self._including}

    def text(self, path: str) -> bytes:
        """The text of a description, by its real path."""
        return self._including.get(path) or self.resolver.read(self.names[path]).data

    def _includes(self, path: str) -> frozenset[str]:
        return self.targets(INCLUDE.findall(without_comments(self._including[path])), path)

    def disabled(self) -> set[str]:
        """The files that only an include in a comment names."""
        found: set[str] = set()
        for path, data in self._including.items():
            text = b"".join(comment[1] for comment in comments(data))
            found |= self.targets(_DISABLED.findall(text), path)
        return found

    def targets(self, names: Iterable[bytes], path: str) -> frozenset[str]:
        """The files that the includes of a file may mean."""
        found: set[str] = set()
        for name in names:
            found.update(self._meant(name.decode("utf-8", "replace"), self.names[path]))
        return frozenset(found - {path})

    def _meant(self, name: str, near: str) -> Iterator[str]:
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
        for path in self.names:
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
        return any(name in self.text(path) for path in closure if path in self.names)

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


def is_description(name: str) -> bool:
    """True for the names that URDF and xacro files have."""
    name = name.lower()  # SolidWorks writes .URDF
    return name.endswith(SUFFIXES) and not name.endswith(OTHER_MODELS)


def _package_directory(file: str, resolver: Resolver) -> str:
    package = resolver.packages.enclosing(file)
    return package[1] if package else os.path.dirname(file)
