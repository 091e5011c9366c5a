"""Cached listings of directories, with case-sensitive lookup of names."""

import os
from collections.abc import Callable, Iterator
from functools import cache, lru_cache

from urdfkit.core import disk
from urdfkit.core.memo import LIMIT

#: Directories created by a build or a virtual environment, and one that macOS adds to archives.
_NOT_SOURCES = frozenset(
    "build install log devel node_modules site-packages __pycache__ __MACOSX".split()
)
#: Lists of files below directories that are kept: those of a package and of its workspace, for
#: some limits. A workspace may have more directories than listings are kept.
_WALKS = 8


def walk(directory: str) -> Iterator[str]:
    """The files below a directory, sorted, without hidden directories and build results."""
    for parent, directories, files in disk.walk(directory):
        directories[:] = sorted(filter(is_walked, directories))
        yield from (os.path.join(parent, name) for name in sorted(files))


def is_walked(name: str) -> bool:
    """False for hidden directories and for directories without sources."""
    return not name.startswith(".") and name not in _NOT_SOURCES


class Directories:
    """Cached listings of directories.

    Files are looked up in the listings, not by their path: a hundred meshes of one directory cost
    one listing, and names that differ in case are distinguished also on case-insensitive file
    systems.
    """

    def __init__(self) -> None:
        #: Names in a directory, with True for directories; None if it cannot be read.
        self.entries: Callable[[str], dict[str, bool] | None] = lru_cache(LIMIT)(self._entries)
        #: Names of entries that are neither files nor directories, such as broken links.
        self._others: dict[str, list[str]] = {}
        self._walked: Callable[[str], list[str]] = cache(self._walk)
        #: The files below a directory, nearest first, without hidden directories and build results,
        #: from at most as many directories as the second argument says.
        self.files_below: Callable[[str, int], tuple[str, ...]] = lru_cache(_WALKS)(
            self._files_below
        )
        self._links: set[str] = set()
        #: Absolute path with all symbolic links resolved.
        self.real: Callable[[str], str] = lru_cache(LIMIT)(self._real)

    def _real(self, path: str) -> str:
        parent, name = os.path.split(path)
        is_plain = parent != path and not disk.is_link(path)
        return os.path.join(self.real(parent), name) if is_plain else disk.real(path)

    def is_link(self, path: str) -> bool:
        """True for a symbolic link in a directory that is already listed."""
        return path in self._links

    def _entries(self, directory: str) -> dict[str, bool] | None:
        try:
            return self._list(directory)
        except (OSError, ValueError):  # ValueError: a NUL in the name
            return None

    def _list(self, directory: str) -> dict[str, bool]:
        entries: dict[str, bool] = {}
        others: list[str] = []  # broken links; pipes and devices, which may never end
        for entry in disk.entries(directory):
            if entry.is_symlink():
                self._links.add(entry.path)
                is_file, is_directory = disk.is_file(entry.path), disk.is_directory(entry.path)
            else:
                is_file, is_directory = entry.is_file(), entry.is_dir()
            if is_file or is_directory:
                entries[entry.name] = is_directory
            else:
                others.append(entry.name)
        if others:
            self._others[directory] = others
        return entries

    def find(self, directory: str, relative: str) -> str | None:
        """The file at a path below a directory, with exact case; None if it does not exist."""
        at = directory
        parts = _parts(relative)
        for number, part in enumerate(parts, start=1):
            if part == "..":
                at = os.path.dirname(at)
                continue
            entries = self.entries(at)
            path = os.path.join(at, part)
            if entries is None:  # files in an unreadable directory may still be readable
                rest = os.path.join(at, *parts[number - 1 :])
                return rest if _is_file(rest) else None
            if entries.get(part) is not (number < len(parts)):
                return None
            at = path
        return at if parts and parts[-1] != ".." else None

    def find_ignoring_case(self, directory: str, relative: str) -> str | None:
        """Like ``find``, but ignores case, and returns a path relative to the directory.

        None if there is no such file, or several.
        """
        at = directory
        parts_on_disk: list[str] = []
        parts = _parts(relative)
        for number, part in enumerate(parts, start=1):
            if part == "..":
                at = os.path.dirname(at)
                parts_on_disk.append(part)
                continue
            entries = self.entries(at) or {}
            is_directory = number < len(parts)
            names = [name for name in _spellings(entries, part) if entries[name] is is_directory]
            if len(names) != 1:
                return None
            parts_on_disk.append(names[0])
            at = os.path.join(at, names[0])
        return "/".join(parts_on_disk) or None

    def walk(self, directory: str) -> list[str]:
        """Like the function `walk`; including broken links, pipes and devices."""
        prefix = os.path.join(directory, "")
        return [prefix + path for path in self._walked(os.path.abspath(directory))]

    def _walk(self, top: str) -> list[str]:
        """The paths below a directory, relative to it."""
        paths: list[str] = []
        stack = [""]  # directories relative to the top, with a trailing separator
        while stack:
            relative = stack.pop()
            at = os.path.join(top, relative[:-1]) if relative else top
            entries = self.entries(at) or {}
            files = [name for name, is_directory in entries.items() if not is_directory]
            files += self._others.get(at, ())
            paths += [relative + name for name in sorted(files)]
            stack += [
                relative + name + os.sep
                for name in sorted(entries, reverse=True)
                if entries[name] and is_walked(name) and not self.is_link(os.path.join(at, name))
            ]
        return paths

    def _files_below(self, directory: str, limit: int) -> tuple[str, ...]:
        paths: list[str] = []
        queue = [directory]
        for at in queue:  # grows during the iteration
            prefix = os.path.join(at, "")
            for name, is_directory in sorted((self.entries(at) or {}).items()):
                path = prefix + name
                if not is_directory:
                    paths.append(path)
                elif len(queue) < limit and is_walked(name) and path not in self._links:
                    queue.append(path)
        return tuple(paths)


def _spellings(entries: dict[str, bool], name: str) -> list[str]:
    """The exact name if it exists, otherwise the names that differ only in case."""
    if name in entries:
        return [name]
    folded = name.casefold()
    return [entry for entry in entries if entry.casefold() == folded]


def _parts(relative: str) -> list[str]:
    return [part for part in relative.split("/") if part not in ("", ".")]


def _is_file(path: str) -> bool:
    try:
        return disk.is_file(path)
    except ValueError:
        return False
