"""Directories of packages, and source files for paths of the installed packages."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterator
from itertools import chain

from urdfkit.core.memo import Memo
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.packages import Candidate, Packages
from urdfkit.workspace.references import spellings

if TYPE_CHECKING:
    from urdfkit.workspace.installs import Installed

_BUILD_FILES = ("CMakeLists.txt", "setup.py")


class PackageFiles:
    """Packages and their files, as a build installs them, cached."""

    def __init__(self, packages: Packages, directories: Directories) -> None:
        self._packages = packages
        self._directories = directories
        #: The directories of all requested packages, each once: models may read them.
        self.chosen: dict[Candidate, None] = {}
        self._candidates: Memo[tuple[str, str], tuple[Candidate, ...]] = Memo()
        self._rules: dict[str, list[Installed]] = {}

    def choose(self, name: str, near: str, relative: str | None) -> Candidate | None:
        """The directory of a package: with its ``package.xml``, otherwise only with its name.

        Of directories that only have the name, the first that contains the file ``relative``.
        """
        key = (name, self._packages.directory_of(near))
        if key not in self._candidates:
            available = _until_certain(self._packages.candidates(name, near))
            self._candidates[key] = tuple(sorted(available, key=lambda item: not item.certain))
            self.chosen.update(dict.fromkeys(self._candidates[key]))
        candidates = self._candidates[key]
        if relative is not None and not all(candidate.certain for candidate in candidates):
            for candidate in candidates:
                if self.find(name, candidate.directory, relative, []):
                    return candidate
        return candidates[0] if candidates else None

    def find(self, name: str, directory: str, relative: str, tried: list[str]) -> str | None:
        """A file of a package; the tried paths are appended to ``tried``."""
        for spelling in spellings(relative):
            tried.append(join(directory, spelling))
            path = self._directories.find(directory, spelling)
            if path:
                return path
        places = (self.as_installed(name, directory, spelling) for spelling in spellings(relative))
        return next(chain.from_iterable(places), None)

    def as_installed(self, name: str, directory: str, relative: str) -> Iterator[str]:
        """The files that a build would install at a path of the package."""
        from urdfkit.workspace.installs import source_paths  # needed only by few packages

        for source in source_paths(self._installed(name, directory), name, relative):
            path = self._directories.find(directory, source)
            if path:
                yield path
        if not any(self._directories.find(directory, file) for file in _BUILD_FILES):
            yield from self._one_level_down(directory, relative)
        elif self._directories.find(directory, "setup.py"):
            yield from self._as_data(name, directory, relative)

    def _as_data(self, name: str, directory: str, relative: str) -> Iterator[str]:
        """The files that a setup.py installs at a path."""
        from urdfkit.workspace.python_installs import patterns_of

        for pattern in patterns_of(directory, name, relative):
            parent, star, rest = pattern.partition("*/")
            entries = self._directories.entries(join(directory, parent)) if star else None
            for entry in sorted(entries or {}) if star else [""]:
                path = self._directories.find(directory, posixpath.join(parent, entry, rest))
                if path:
                    yield path

    def _installed(self, name: str, directory: str) -> list[Installed]:
        """Install rules of the CMakeLists.txt of a package."""
        if directory not in self._rules:
            from urdfkit.workspace.installs import read_rules

            has_file = self._directories.find(directory, "CMakeLists.txt") is not None
            self._rules[directory] = read_rules(directory, name) if has_file else []
        return self._rules[directory]

    def _one_level_down(self, directory: str, relative: str) -> Iterator[str]:
        """The only file at this path in a subdirectory, if no build file defines the layout.

        Builds often strip the first directory of ``description/urdf`` or ``bringup/launch``.
        """
        entries = self._directories.entries(directory) or {}
        names = sorted(name for name, is_directory in entries.items() if is_directory)
        candidates = (self._directories.find(directory, f"{name}/{relative}") for name in names)
        paths = [path for path in candidates if path]
        if len(paths) == 1:
            yield paths[0]


def _until_certain(candidates: Iterator[Candidate]) -> Iterator[Candidate]:
    for candidate in candidates:
        yield candidate
        if candidate.certain:
            return


def join(directory: str, relative: str) -> str:
    """A normalised path below a directory."""
    return os.path.normpath(os.path.join(directory, relative))
