"""What a run has asked of the file system and of the environment, and whether it still holds.

An answer is a text. That of a directory, or of a file that was read, begins with its time of
change, size and inode: as long as these are the same and older than the answer, the content is,
too. Else the content itself is compared, by its hash.
"""

from __future__ import annotations

import os
from stat import S_IFMT, S_ISLNK

from urdfkit.core.regular_file import opened

TYPE_CHECKING = False

if TYPE_CHECKING:
    from collections.abc import Iterable

#: The answer if there is nothing, or nothing that may be read.
NOTHING = "-"

#: Answers that are noted; with more, which take 20 MB, there is no result to keep.
MAX_ANSWERS = 50_000

#: A file that changed so shortly before it was read may change again without a new time: file
#: systems count in steps of up to 2 s (FAT).
_RACE_NS = 2_000_000_000


class FileLog:
    """Questions with their answers."""

    def __init__(self) -> None:
        #: By kind and path. ``r`` is a file that was read, with the number of bytes if not the
        #: whole; ``t`` its time of change, ``s`` the type and size of a file, ``k`` its type alone,
        #: ``l`` whether it is a link, ``d`` the names in a directory, ``p`` where a path leads,
        #: ``v`` a variable.
        self.answers: dict[tuple[str, str], str] = {}
        #: False if the result depends on something else as well, or a file changed.
        self.is_complete = True

    def read(
        self, path: str, most: int, data: bytes | None = None, state: os.stat_result | None = None
    ) -> None:
        """A file was opened and read, or could not be."""
        if data is None or state is None:
            self._note(f"r{most}", path, NOTHING)
            return
        kind = "r" if len(data) == state.st_size else f"r{most}"
        known = self.answers.get((kind, path), NOTHING)
        if not known.startswith(f"{_time(state)} "):  # else it was hashed already
            self._note(kind, path, f"{_time(state)} {_digest(data)}")

    def time(self, path: str) -> None:
        """A file is one that another time of change makes another file."""
        self._note("t", path, _time(_state(path)))

    def state(self, path: str, state: os.stat_result | None) -> None:
        """The type and the size of a file were looked at."""
        self._note("s", path, _size(state))

    def kind(self, path: str, state: os.stat_result | None) -> None:
        """The type of a file was looked at."""
        self._note("k", path, _type(state))

    def link(self, path: str, state: os.stat_result | None) -> None:
        """Whether a file is a link was looked at."""
        self._note("l", path, _link(state))

    def listed(self, directory: str, names: Iterable[str] | None) -> None:
        """The names in a directory were looked at."""
        try:
            state = os.stat(directory)
        except (OSError, ValueError):
            names = None
        self._note(
            "d", directory, NOTHING if names is None else f"{_time(state)} {_of_names(names)}"
        )

    def real(self, path: str, real: str) -> None:
        """Where a path leads was looked at; it matters if there is a link on the way."""
        if real != os.path.abspath(path):
            self._note("p", path, real)

    def variable(self, name: str, value: str | None) -> None:
        """An environment variable was looked at."""
        self._note("v", name, _variable(value))

    def add(self, other: FileLog) -> None:
        """Take over what another process has noted."""
        self.is_complete = self.is_complete and other.is_complete
        for (kind, path), answer in other.answers.items():
            self._note(kind, path, answer)

    def _note(self, kind: str, path: str, answer: str) -> None:
        if "\0" in path:
            return  # no file has such a name, today or later
        if self.answers.setdefault((kind, path), answer) != answer:
            self.is_complete = False
        if len(self.answers) > MAX_ANSWERS:
            self.is_complete = False
            self.answers.clear()


def answers_again(
    answers: Iterable[tuple[str, str, str]], since: int
) -> list[tuple[str, str, str]] | None:
    """The answers as they are now, if all mean the same; None if one is another one.

    Args:
        since: nanoseconds since the epoch, before the answers were given.
    """
    found = []
    for kind, path, answer in answers:
        again = answer_again(kind, path, answer, since)
        if again is None:
            return None
        found.append((kind, path, again))
    return found


def answer_again(kind: str, path: str, answer: str, since: int) -> str | None:
    """The answer as it is now, if it means the same; None if it is another one.

    Args:
        path: as of the question.
        since: nanoseconds since the epoch, before the answer was given.
    """
    if kind[0] in "rd":
        return _content_again(kind, path, answer, since)
    if kind == "v":
        now = _variable(os.environ.get(path))
    elif kind == "p":
        now = os.path.realpath(path)
    elif kind == "l":
        now = _link(_state(path, follow=False))
    elif kind == "t":
        now = _time(_state(path))
    else:
        now = (_size if kind == "s" else _type)(_state(path))
    return answer if now == answer else None


def _content_again(kind: str, path: str, answer: str, since: int) -> str | None:
    state = _state(path)
    time = _time(state)
    if state is not None and answer.startswith(f"{time} ") and state.st_mtime_ns + _RACE_NS < since:
        return answer
    try:
        if kind == "d":
            digest = _of_names(os.listdir(path))
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
    return NOTHING if state is None else f"{state.st_mtime_ns} {state.st_size} {state.st_ino}"


def _type(state: os.stat_result | None) -> str:
    return NOTHING if state is None else f"{S_IFMT(state.st_mode):o}"


def _size(state: os.stat_result | None) -> str:
    return NOTHING if state is None else f"{_type(state)} {state.st_size}"


def _link(state: os.stat_result | None) -> str:
    return NOTHING if state is None else "link" if S_ISLNK(state.st_mode) else "other"


def _variable(value: str | None) -> str:
    return NOTHING if value is None else f"={value}"


def _of_names(names: Iterable[str]) -> str:
    return _digest(b"\0".join(sorted(map(os.fsencode, names))))


def _digest(data: bytes) -> str:
    from urdfkit.core.digest import blake2b

    return blake2b(data, digest_size=16).hexdigest()
