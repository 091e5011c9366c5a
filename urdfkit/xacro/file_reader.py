"""Reading of the files of an expansion, limited to the workspace and in size."""

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
    """Reads files for all runs of an expansion, every xacro file once.

    Args:
        resolver: decides which files may be read, and finds files of installed packages.
        near: path of the checked file, relative to the working directory.
        trust: True to read any file.
    """

    def __init__(self, source: Source, resolver: Resolver, *, near: str, trust: bool) -> None:
        #: The xacro files by path, the checked file first.
        self.sources: dict[str, Source] = {source.path: source}
        self.data_files: list[str] = []  # the YAML files
        self._near = near
        self._resolver = resolver
        self._trust = trust

    def xacro(self, path: str) -> Source:
        """A xacro file.

        Raises:
            OSError: it cannot be read.
            ValueError: the path is invalid.
            EscapesRoots: it is outside of the workspace and the packages.
            TooLarge: it is too large.
        """
        path = self._admitted(path)
        if path not in self.sources:
            self.sources[path] = Source(path, self._read(path, MAX_BYTES))
        return self.sources[path]

    def yaml(self, path: str) -> Source:
        """A YAML file.

        Raises:
            OSError, ValueError, EscapesRoots, TooLarge: as for ``xacro``.
        """
        path = self._admitted(path)
        self.data_files.append(path)
        data = self._read(path, MAX_LENGTH)
        data.decode("utf-8")  # as strict as xacro
        return Source(path, data)

    def _read(self, path: str, most: int) -> bytes:
        data = self._resolver.text(path)
        if data is None:
            data = disk.read(path, most + 1)
        if len(data) > most:
            raise TooLarge(f"the file {path} of more than {most} bytes")
        return data

    def _admitted(self, path: str) -> str:
        """The path to open: the source of an installed file, if the path does not exist."""
        if not disk.exists(path):
            path = self._resolver.installed(path) or path
        if disk.has_name(path):  # opening a missing file raises the error
            self._reject_outside(path)
        return path

    def _reject_outside(self, path: str) -> None:
        if self._trust or self._resolver.allows(path, self._near):
            return
        if disk.exists(path) and not disk.is_file(path) and not disk.is_directory(path):
            raise EscapesRoots(f"{path} is a device or a pipe, not a file")
        raise EscapesRoots(f"{path} {OUTSIDE}")

    def glob(self, pattern: str, budget: Budget) -> Iterator[str]:
        """The paths of ``glob.glob``, searched only in admitted directories.

        Args:
            budget: pays for the search.

        Raises:
            EscapesRoots: the pattern leads outside.
            DocumentTooLarge: it takes too long; circular links multiply the paths.
        """
        directory, name = os.path.split(pattern)
        if not re.search(_WILDCARD, pattern):
            if disk.has_name(pattern) if name else disk.is_directory(directory):
                yield pattern
            return
        directories: Iterable[str] = [directory]
        if re.search(_WILDCARD, directory) and directory != pattern:
            directories = self.glob(directory, budget)
        for parent in directories:
            if re.search(_WILDCARD, name):
                yield from self._matching(parent, name, budget)
            elif disk.has_name(path := os.path.join(parent, name)):
                yield path

    def _matching(self, directory: str, pattern: str, budget: Budget) -> Iterator[str]:
        budget.charge(ELEMENT_SIZE)  # takes as long as an element
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
