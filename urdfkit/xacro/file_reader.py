"""The files of all attempts at one expansion, within the workspace and within bounds."""

import fnmatch
import os
import re
from collections.abc import Iterable, Iterator

from urdfkit.core import disk
from urdfkit.text.source import MAX_BYTES, Source
from urdfkit.workspace.resolve import OUTSIDE, Resolver
from urdfkit.xacro.bounds import MAX_LENGTH, TooLarge
from urdfkit.xacro.budget import ELEMENT_SIZE, Budget
from urdfkit.xacro.errors import EscapesRoots

_WILDCARD = r"[*?[]"


class FileReader:
    """Reads files; every xacro file once.

    Args:
        resolver: knows which files may be read, and where those of an installed package are.
        near: path of the checked file, from the working directory.
        trust: True to read any file.
    """

    def __init__(self, source: Source, resolver: Resolver, *, near: str, trust: bool) -> None:
        #: The xacro files by path, the checked one first.
        self.sources: dict[str, Source] = {source.path: source}
        self.data_files: list[str] = []  # the YAML files
        self._near = near
        self._resolver = resolver
        self._trust = trust

    def xacro(self, path: str) -> Source:
        """A xacro file.

        Raises:
            OSError: it cannot be read.
            ValueError: its name is none.
            EscapesRoots: it is outside.
            TooLarge: no robot needs one of that size.
        """
        path = self._admitted(path)
        if path not in self.sources:
            self.sources[path] = Source(path, self._read(path, MAX_BYTES))
        return self.sources[path]

    def yaml(self, path: str) -> Source:
        """A YAML file.

        Raises:
            OSError, ValueError, EscapesRoots, TooLarge: as of ``xacro``.
        """
        path = self._admitted(path)
        self.data_files.append(path)
        data = self._read(path, MAX_LENGTH)
        data.decode("utf-8")  # as strictly as xacro does
        return Source(path, data)

    def _read(self, path: str, most: int) -> bytes:
        data = self._resolver.text(path)
        if data is None:
            data = disk.read(path, most + 1)
        if len(data) > most:
            raise TooLarge(f"the file {path} of more than {most} bytes")
        return data

    def _admitted(self, path: str) -> str:
        """The path to open: as installed if it is not in the source tree, and not outside."""
        if not disk.exists(path):
            path = self._resolver.installed(path) or path
        if disk.has_name(path):  # else opening it will say that there is no such file
            self._reject_outside(path)
        return path

    def _reject_outside(self, path: str) -> None:
        if self._trust or self._resolver.allows(path, self._near):
            return
        if disk.exists(path) and not disk.is_file(path) and not disk.is_directory(path):
            raise EscapesRoots(f"{path} is a device or a pipe, not a file")
        raise EscapesRoots(f"{path} {OUTSIDE}")

    def glob(self, pattern: str, budget: Budget) -> Iterator[str]:
        """The paths that ``glob.glob`` gives, searched for in admitted directories only.

        Args:
            budget: that the search is charged to.

        Raises:
            EscapesRoots: the pattern leads outside.
            TooMuch: it takes too long; links that lead in circles multiply the paths.
        """
        directory, name = os.path.split(pattern)
        if not re.search(_WILDCARD, pattern):
            if disk.has_name(pattern) if name else disk.is_directory(directory):
                yield pattern
            return
        directories: Iterable[str] = [directory]
        if re.search(_WILDCARD, directory) and directory != pattern:
            directories = self.glob(directory, budget)
        for inside in directories:
            if re.search(_WILDCARD, name):
                yield from self._matching(inside, name, budget)
            elif disk.has_name(path := os.path.join(inside, name)):
                yield path

    def _matching(self, directory: str, pattern: str, budget: Budget) -> Iterator[str]:
        budget.charge(ELEMENT_SIZE)  # it takes as long
        if not disk.is_directory(directory or os.curdir):
            return
        self._reject_outside(directory or os.curdir)
        try:
            names = disk.names(directory or os.curdir)
        except OSError:
            return
        budget.charge(len(names))
        for name in fnmatch.filter(names, pattern):
            if pattern.startswith(".") or not name.startswith("."):
                yield os.path.join(directory, name)
