"""The gate to the files that are read on behalf of a robot.

Whatever a robot, a configuration or a directory makes urdfkit open, look for or list is asked for
here, so that one place knows what a result depends on (`log_to`). Files of urdfkit itself, and
what is written, do not pass.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from errno import EFBIG
from stat import S_ISDIR, S_ISLNK, S_ISREG

from urdfkit.core.regular_file import opened

TYPE_CHECKING = False  # ``typing`` takes longer to import than all that this does

if TYPE_CHECKING:
    from urdfkit.core.file_log import FileLog

#: Files that are read as a whole are no longer than this: meshes are the longest.
MAX_BYTES = 128 * 1024 * 1024

_log: FileLog | None = None


def log_to(log: FileLog | None) -> None:
    """Note from now on what this process asks for; None ends it."""
    global _log  # noqa: PLW0603 - one process answers one command line
    _log = log


def log() -> FileLog | None:
    """What this process notes; None if nothing."""
    return _log


def depends_on_more() -> None:
    """The result depends on something besides files and variables: a program, the time."""
    if _log is not None:
        _log.is_complete = False


def read(path: str | os.PathLike[str], most: int = -1) -> bytes:
    """The bytes of a file.

    Args:
        path: of the file.
        most: so many from its beginning; all if negative.

    Raises:
        OSError: it cannot be opened, is no regular file, or all of it is more than ``MAX_BYTES``.
        ValueError: there is a NUL in its name.
    """
    path = os.fspath(path)
    try:
        with opened(path) as file:
            data = file.read(MAX_BYTES + 1 if most < 0 else most)
            state = os.fstat(file.fileno()) if _log is not None else None
        if most < 0 and len(data) > MAX_BYTES:
            raise OSError(EFBIG, f"larger than {MAX_BYTES // 2**20} MiB", path)
    except OSError:
        if _log is not None:
            _log.read(path, most)
        raise
    if _log is not None:
        _log.read(path, most, data, state)
    return data


def state(path: str) -> os.stat_result:
    """What the system knows of a file; links are followed.

    Raises:
        OSError: there is none.
        ValueError: there is a NUL in its name.
    """
    try:
        found = os.stat(path)
    except OSError:
        if _log is not None:
            _log.state(path, None)
        raise
    if _log is not None:
        _log.state(path, found)
    return found


def version(path: str) -> tuple[int, ...]:
    """Numbers that differ once a file has changed; nothing is noted, as its text is.

    Raises:
        OSError, ValueError: as of `state`.
    """
    found = os.stat(path)
    return found.st_dev, found.st_ino, found.st_size, found.st_mtime_ns


def exists(path: str) -> bool:
    return _mode(path) != 0


def is_file(path: str) -> bool:
    """True of a regular file, or a link to one."""
    return S_ISREG(_mode(path))


def is_directory(path: str) -> bool:
    """True of a directory, or a link to one."""
    return S_ISDIR(_mode(path))


def is_link(path: str) -> bool:
    """True of a symbolic link, wherever it leads."""
    return S_ISLNK(_link_mode(path))


def has_name(path: str) -> bool:
    """True if something is there, even a link that leads nowhere."""
    return _link_mode(path) != 0


def names(directory: str) -> list[str]:
    """The names in a directory.

    Raises:
        OSError: it is none, or may not be read.
        ValueError: there is a NUL in its name.
    """
    return [entry.name for entry in entries(directory)]


def entries(directory: str) -> list[os.DirEntry[str]]:
    """What is in a directory.

    Raises:
        OSError: it is none, or may not be read.
        ValueError: there is a NUL in its name.
    """
    try:
        with os.scandir(directory) as found:
            inside = list(found)
    except OSError:
        if _log is not None:
            _log.listed(directory, None)
        raise
    if _log is not None:
        _log.listed(directory, [entry.name for entry in inside])
    return inside


def walk(directory: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """As ``os.walk``: directories from the top, with the directories and files in each."""
    for parent, directories, inside in os.walk(directory, onerror=_note_closed):
        if _log is not None:
            _log.listed(parent, [*directories, *inside])
        yield parent, directories, inside


def _note_closed(error: OSError) -> None:
    if _log is not None:
        _log.listed(error.filename, None)


def real(path: str) -> str:
    """An absolute path without symbolic links on the way."""
    found = os.path.realpath(path)
    if _log is not None:
        _log.real(path, found)
    return found


class Environment(Mapping[str, str]):
    """The environment variables of the process."""

    def __getitem__(self, name: str) -> str:
        if _log is not None:
            _log.variable(name, os.environ.get(name))
        return os.environ[name]

    def __iter__(self) -> Iterator[str]:
        return iter(os.environ)

    def __len__(self) -> int:
        return len(os.environ)


def _mode(path: str) -> int:
    """What kind of file a path leads to; 0 for nothing."""
    try:
        found = os.stat(path)
    except (OSError, ValueError):
        found = None
    if _log is not None:
        _log.kind(path, found)
    return found.st_mode if found is not None else 0


def _link_mode(path: str) -> int:
    """What kind of file a path is itself; 0 for nothing."""
    try:
        found = os.lstat(path)
    except (OSError, ValueError):
        found = None
    if _log is not None:
        _log.link(path, found)
    return found.st_mode if found is not None else 0
