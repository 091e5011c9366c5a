"""Scanning a directory for packages, breadth first and within bounds."""

import os
import time

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.core.words import counted
from urdfkit.workspace.directories import is_walked
from urdfkit.workspace.package_directories import PackageDirectories

#: A scan stops here and says so. Real workspaces have some thousand directories.
MAX_DIRECTORIES = 20_000
MAX_SECONDS = 2.0


class PackageScan:
    """The packages below a directory, breadth first, no further than has been asked for.

    Of two packages with one name, the nearest to the root counts, then the first by path.
    """

    def __init__(
        self, directories: PackageDirectories, root: str, depth: int, *, nested: bool
    ) -> None:
        self.root = root
        self._directories = directories
        self._depth = depth
        self._nested = nested
        self._queue: list[tuple[str, int]] = [(root, 0)]
        self._next = 0
        self._seconds = 0.0
        self._found: dict[str, str] = {}
        self._linked: set[str] = set()

    def find(self, name: str) -> str | None:
        """The directory of a package; None if there is none."""
        started = time.monotonic()
        while name not in self._found and self._more(started):
            self._visit(*self._queue[self._next])
            self._next += 1
        self._seconds += time.monotonic() - started
        return self._found.get(name)

    def all(self) -> dict[str, str]:
        self.find("")
        return self._found

    def words(self) -> str:
        """What was scanned, and how far."""
        self.find("")
        is_done = self._next == len(self._queue)
        stopped = "" if is_done else f", stopped after {self._next} directories"
        return f"{self.root} ({counted(len(self._found), 'package')}{stopped})"

    def _more(self, started: float) -> bool:
        if self._next >= min(len(self._queue), MAX_DIRECTORIES):
            return False
        if self._seconds + time.monotonic() - started < MAX_SECONDS:
            return True
        disk.depends_on_more()  # on a faster machine it would have gone on
        return False

    def _visit(self, directory: str, depth: int) -> None:
        entries = self._directories.names_in(directory)
        if "package.xml" in entries or "manifest.xml" in entries:
            name = self._directories.name_of(directory)
            if name:
                self._found.setdefault(name, directory)
                if not self._nested and depth:
                    return
        if depth >= self._depth:
            return
        for entry in sorted(entries):
            if entries[entry] and is_walked(entry):
                path = os.path.join(directory, entry)
                if not self._is_left_out(path):
                    self._queue.append((path, depth + 1))

    def _is_left_out(self, path: str) -> bool:
        """True of a symbolic link to where another led, to a directory around it, or outside."""
        if not self._directories.listings.is_link(path):
            return False
        real = disk.real(path)
        is_circle = real in self._linked or is_within(path, real)
        if is_circle or (self._nested and self._leads_out(path, real)):
            return True
        self._linked.add(real)
        return False

    def _leads_out(self, path: str, real: str) -> bool:
        """True if a link leads out of the repository that it is a part of.

        Its author may be a stranger. In the ``src`` of a workspace the user puts links himself.
        """
        above = list(upwards(os.path.dirname(path)))
        repository = next((at for at in above if disk.exists(os.path.join(at, ".git"))), None)
        if repository is None and os.path.basename(above[0]) == "src":
            return False
        return not is_within(real, disk.real(repository or self.root))
