"""Which directory a package is, and which of its files a path in the installed package means."""

from __future__ import annotations

import os
import posixpath
from collections.abc import Iterator

from urdfkit.core.memo import Memo
from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.workspace.directories import Directories
from urdfkit.workspace.packages import Candidate, Packages
from urdfkit.workspace.references import spellings

if TYPE_CHECKING:
    from urdfkit.workspace.installs import Installed

_BUILD_FILES = ("CMakeLists.txt", "setup.py")


class PackageFiles:
    """Packages and their files, as a build installs them; everything is read once."""

    def __init__(self, packages: Packages, directories: Directories) -> None:
        self._packages = packages
        self._directories = directories
        #: The directories of all packages that were asked for, each once: models may read them.
        self.chosen: dict[Candidate, None] = {}
        self._candidates: Memo[tuple[str, str], tuple[Candidate, ...]] = Memo()
        self._rules: dict[str, list[Installed]] = {}

    def choose(self, name: str, near: str, relative: str | None) -> Candidate | None:
        """The directory of a package: one with its ``package.xml``, else one that is called so.

        Where some are only called so, the first that has the wanted file.
        """
        key = (name, self._packages.directory_of(near))
        if key not in self._candidates:
            found = _until_certain(self._packages.candidates(name, near))
            self._candidates[key] = tuple(sorted(found, key=lambda one: not one.certain))
            self.chosen.update(dict.fromkeys(self._candidates[key]))
        candidates = self._candidates[key]
        if relative is not None and not all(candidate.certain for candidate in candidates):
            for candidate in candidates:
                if self.find(name, candidate.directory, relative, []):
                    return candidate
        return candidates[0] if candidates else None

    def find(self, name: str, directory: str, relative: str, tried: list[str]) -> str | None:
        """A file of a package; the paths looked at are added to ``tried``."""
        for spelling in spellings(relative):
            tried.append(join(directory, spelling))
            path = self._directories.find(directory, spelling)
            if path:
                return path
        for spelling in spellings(relative):
            for path in self.as_installed(name, directory, spelling):
                return path
        return None

    def as_installed(self, name: str, directory: str, relative: str) -> Iterator[str]:
        """The files that a build would install at a path of the package."""
        from urdfkit.workspace.installs import source_paths  # needed by few packages only

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
            above, star, rest = pattern.partition("*/")
            inside = self._directories.entries(join(directory, above)) if star else None
            for one in sorted(inside or {}) if star else [""]:
                path = self._directories.find(directory, posixpath.join(above, one, rest))
                if path:
                    yield path

    def _installed(self, name: str, directory: str) -> list[Installed]:
        """What the build of a package installs; its CMakeLists.txt is read once."""
        if directory not in self._rules:
            from urdfkit.workspace.installs import read_rules

            is_there = self._directories.find(directory, "CMakeLists.txt") is not None
            self._rules[directory] = read_rules(directory, name) if is_there else []
        return self._rules[directory]

    def _one_level_down(self, directory: str, relative: str) -> Iterator[str]:
        """The only file at this path in a subdirectory, where no build file gives the layout.

        ``description/urdf`` and ``bringup/launch`` are the usual directories that a build removes.
        """
        entries = self._directories.entries(directory) or {}
        inside = sorted(name for name, is_directory in entries.items() if is_directory)
        found = [self._directories.find(directory, f"{name}/{relative}") for name in inside]
        paths = [path for path in found if path]
        if len(paths) == 1:
            yield paths[0]


def _until_certain(candidates: Iterator[Candidate]) -> Iterator[Candidate]:
    for candidate in candidates:
        yield candidate
        if candidate.certain:
            return


def join(directory: str, relative: str) -> str:
    """A path below a directory, without ``..`` in it."""
    return os.path.normpath(os.path.join(directory, relative))
