"""Bounded breadth-first scan of a directory for packages."""

import os
import time

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.words import counted
from urdfkit.workspace.directories import is_walked
from urdfkit.workspace.package_directories import IGNORE_FILES, PackageDirectories

#: Limits of a scan, which reports that it stopped. Real workspaces have some thousand directories.
MAX_DIRECTORIES = 20_000
MAX_SECONDS = 2.0


class PackageScan:
    """The packages below a directory; the scan continues only as far as queries require.

    Of two packages with the same name, one that is built counts, then the nearest to the root, then
    the first by path.
    """

    def __init__(
        self, directories: PackageDirectories, root: str, depth: int, *, nested: bool
    ) -> None:
        self.root = root
        self._directories = directories
        self._depth = depth
        self._nested = nested
        self._queue: list[tuple[str, int]] = [(root, 0)]
        #: The directories that a build skips, which come last; None once they are in the queue.
        self._ignored: list[tuple[str, int]] | None = []
        self._next = 0
        self._seconds = 0.0
        self._packages: dict[str, str] = {}
        self._linked: set[str] = set()

    def find(self, name: str) -> str | None:
        """The directory of a package; None if it is not found."""
        started = time.monotonic()
        while name not in self._packages and self._may_continue(started):
            self._visit(*self._queue[self._next])
            self._next += 1
        self._seconds += time.monotonic() - started
        return self._packages.get(name)

    def all(self) -> dict[str, str]:
        self.find("")
        return self._packages

    def summary(self) -> str:
        """``below DIRECTORY``, the number of packages and whether a limit stopped the scan."""
        self.find("")
        is_done = self._next == len(self._queue)
        stopped = "" if is_done else f", stopped after {self._next} directories"
        return f"below {self.root} ({counted(len(self._packages), 'package')}{stopped})"

    def _may_continue(self, started: float) -> bool:
        if self._next == len(self._queue) and self._ignored:
            self._queue += self._ignored
            self._ignored = None
        if self._next >= min(len(self._queue), MAX_DIRECTORIES):
            return False
        if self._seconds + time.monotonic() - started < MAX_SECONDS:
            return True
        disk.depends_on_more()  # a faster machine would continue
        return False

    def _visit(self, directory: str, depth: int) -> None:
        entries = self._directories.names_in(directory)
        if depth and self._ignored is not None and any(map(entries.__contains__, IGNORE_FILES)):
            self._ignored.append((directory, depth))
            return
        if "package.xml" in entries or "manifest.xml" in entries:
            name = self._directories.name_of(directory)
            if name:
                self._packages.setdefault(name, directory)
                if not self._nested and depth:
                    return
        if depth >= self._depth:
            return
        for entry in sorted(entries):
            if entries[entry] and is_walked(entry):
                path = os.path.join(directory, entry)
                if not self._is_excluded(path):
                    self._queue.append((path, depth + 1))

    def _is_excluded(self, path: str) -> bool:
        """True for a symbolic link to a visited target, to its own parents, or to the outside."""
        if not self._directories.listings.is_link(path):
            return False
        real = disk.real(path)
        is_repeated = real in self._linked or is_within(path, real)
        if is_repeated or (self._nested and self._leaves_repository(path, real)):
            return True
        self._linked.add(real)
        return False

    def _leaves_repository(self, path: str, real: str) -> bool:
        """True if the target of a link is outside of the link's repository.

        The author of a repository is not trusted. Links in the ``src`` of a workspace are the
        user's own.
        """
        parents = list(upwards(os.path.dirname(path)))
        repository = next((at for at in parents if disk.exists(os.path.join(at, ".git"))), None)
        if repository is None and os.path.basename(parents[0]) == "src":
            return False
        return not is_within(real, disk.real(repository or self.root))
