"""Log of a run's queries to the file system and the environment, and whether they changed since.

Answers are strings. The answer for a directory or a file that was read begins with its times of
change, size and inode: as long as these are unchanged and older than the answer, so is the
content. Otherwise the hash of the content is compared.
"""

from __future__ import annotations

import os
import time
from stat import S_ISLNK, S_ISREG

from urdfkit.core.regular_file import opened

TYPE_CHECKING = False

if TYPE_CHECKING:
    from collections.abc import Iterable

#: Answer for a file or variable that does not exist or is not readable.
NOTHING = "-"

#: Most answers (20 MB); a run with more is not cached.
MAX_ANSWERS = 50_000

#: A file that changed this shortly before it was read may change again without a new modification
#: time: file systems count in steps of up to 2 s (FAT).
_RACE_NS = 2_000_000_000


class FileLog:
    """Queries with their answers."""

    def __init__(self) -> None:
        #: By kind of query and path. ``r``: contents of a file, followed by the number of bytes if
        #: only a part was read; ``t``: times of change; ``s``: mode and size; ``k``: mode;
        #: ``l``: whether it is a link; ``d``: names and types in a directory; ``p``: resolved path;
        #: ``v``: environment variable.
        self.answers: dict[tuple[str, str], str] = {}
        #: False if the result depends on anything else, or a file changed during the run.
        self.is_complete = True

    def read(
        self, path: str, most: int, data: bytes | None = None, state: os.stat_result | None = None
    ) -> None:
        """Log the contents of a file; ``data`` is None if it could not be read."""
        if data is None or state is None:
            self._add(f"r{most}", path, NOTHING)
            return
        if not S_ISREG(state.st_mode):  # a pipe, which can be read once
            self.is_complete = False
        kind = "r" if len(data) == state.st_size else f"r{most}"
        known = self.answers.get((kind, path), NOTHING)
        if not known.startswith(f"{_time(state)} "):  # otherwise it has been hashed
            self._add(kind, path, f"{_time(state)} {_digest(data)}")

    def time(self, path: str) -> None:
        """Log the times of change of a file, which stand for its contents."""
        self.state("t", path, _state(path))

    def state(self, kind: str, path: str, state: os.stat_result | None) -> None:
        """Log what a kind of query, one of ``t``, ``s``, ``k`` and ``l``, tells of a file."""
        self._add(kind, path, _STATES[kind](state))

    def listed(self, directory: str, entries: Iterable[os.DirEntry[str]] | None) -> None:
        """Log the names and types in a directory."""
        try:
            state = os.stat(directory)
        except (OSError, ValueError):
            entries = None
        answer = NOTHING if entries is None else f"{_time(state)} {_entries_digest(entries)}"
        self._add("d", directory, answer)

    def real(self, path: str, real: str) -> None:
        """Log the resolved path of a path that contains a link."""
        if real != os.path.abspath(path):
            self._add("p", path, real)

    def variable(self, name: str, value: str | None) -> None:
        """Log an environment variable."""
        self._add("v", name, _variable(value))

    def add(self, other: FileLog) -> None:
        """Add the log of another process."""
        self.is_complete = self.is_complete and other.is_complete
        for (kind, path), answer in other.answers.items():
            self._add(kind, path, answer)

    def _add(self, kind: str, path: str, answer: str) -> None:
        if "\0" in path:
            return  # no file can have such a name
        if self.answers.setdefault((kind, path), answer) != answer:
            self.is_complete = False
        if len(self.answers) > MAX_ANSWERS:
            self.is_complete = False
            self.answers.clear()


class WatchedFiles:
    """The queries of a run, asked again and again.

    Args:
        log: of the run.
        since: start of the run, in nanoseconds since the epoch.
        listings: also watch which files a directory has, which any program may change.
    """

    def __init__(self, log: FileLog, since: int, *, listings: bool = True) -> None:
        self._answers = [
            (kind, path, answer)
            for (kind, path), answer in log.answers.items()
            if listings or kind != "d"
        ]
        self._since = since
        contents = (each for each in self._answers if each[0][0] in "rt" and each[2] != NOTHING)
        self.count = len({path for _, path, _ in contents})  # of the files that were read

    @property
    def have_changed(self) -> bool:
        """True if an answer has changed since the run."""
        now = time.time_ns()
        unchanged = present_answers(self._answers, self._since)
        if unchanged is not None:
            self._answers, self._since = unchanged, now
        return unchanged is None


def present_answers(
    answers: Iterable[tuple[str, str, str]], since: int
) -> list[tuple[str, str, str]] | None:
    """The present answers to logged queries; None if one of them has changed.

    Args:
        since: time before the answers were given, in nanoseconds since the epoch.
    """
    results = []
    for kind, path, answer in answers:
        present = present_answer(kind, path, answer, since)
        if present is None:
            return None
        results.append((kind, path, present))
    return results


def present_answer(kind: str, path: str, answer: str, since: int) -> str | None:
    """The present answer to a query; None if it has changed.

    Args:
        path: of the query.
        since: time before the answer was given, in nanoseconds since the epoch.
    """
    if kind[0] in "rd":
        return _present_content(kind, path, answer, since)
    if kind == "v":
        now = _variable(os.environ.get(path))
    elif kind == "p":
        now = os.path.realpath(path)
    else:
        now = _STATES[kind](_state(path, follow=kind != "l"))
    return answer if now == answer else None


def _present_content(kind: str, path: str, answer: str, since: int) -> str | None:
    state = _state(path)
    time = _time(state)
    if state and answer.startswith(f"{time} "):
        last_change = max(state.st_mtime_ns, state.st_ctime_ns)
        if last_change + _RACE_NS < since:
            return answer
    try:
        if kind == "d":
            with os.scandir(path) as entries:
                digest = _entries_digest(entries)
        else:
            with opened(path) as file:
                digest = _digest(file.read(int(kind[1:] or -1)))
    except (OSError, ValueError):
        return answer if answer == NOTHING else None
    return f"{time} {digest}" if digest == answer.rpartition(" ")[2] else None


def _state(path: str, *, follow: bool = True) -> os.stat_result | None:
    try:
        return os.stat(path, follow_symlinks=follow)
    except (OSError, ValueError):
        return None


def _time(state: os.stat_result | None) -> str:
    """Times of change, size and inode; a program can set back ``mtime``, but not ``ctime``."""
    if state is None:
        return NOTHING
    return f"{state.st_mtime_ns} {state.st_ctime_ns} {state.st_size} {state.st_ino}"


def _mode(state: os.stat_result | None) -> str:
    return NOTHING if state is None else f"{state.st_mode:o}"


def _size(state: os.stat_result | None) -> str:
    return NOTHING if state is None else f"{_mode(state)} {state.st_size}"


def _link(state: os.stat_result | None) -> str:
    return NOTHING if state is None else "link" if S_ISLNK(state.st_mode) else "other"


#: Answers to the kinds of queries about the state of a file.
_STATES = {"t": _time, "s": _size, "k": _mode, "l": _link}


def _variable(value: str | None) -> str:
    return NOTHING if value is None else f"={value}"


def _entries_digest(entries: Iterable[os.DirEntry[str]]) -> str:
    return _digest(b"\0".join(sorted(os.fsencode(_type(entry) + entry.name) for entry in entries)))


def _type(entry: os.DirEntry[str]) -> str:
    if entry.is_symlink():
        return "l"
    if entry.is_dir(follow_symlinks=False):
        return "d"
    return "f" if entry.is_file(follow_symlinks=False) else "o"


def _digest(data: bytes) -> str:
    from urdfkit.core.digest import blake2b

    return blake2b(data, digest_size=16).hexdigest()
