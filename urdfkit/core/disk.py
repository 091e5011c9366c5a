"""All reading from disk on behalf of a robot.

Files and directories that a robot, a configuration or a search needs are opened, looked for and
listed through this module only, so that it can log what a result depends on (`log_to`). Files of
urdfkit itself, and writing, do not pass through it.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Mapping
from errno import EFBIG
from stat import S_ISDIR, S_ISLNK, S_ISREG

from urdfkit.core.regular_file import opened

TYPE_CHECKING = False  # importing ``typing`` would take longer than this module

if TYPE_CHECKING:
    from urdfkit.core.file_log import FileLog

#: Limit for files that are read completely; meshes are the largest.
MAX_BYTES = 128 * 1024 * 1024

_log: FileLog | None = None


def log_to(log: FileLog | None) -> None:
    """Log all further accesses of this process; None stops logging."""
    global _log  # noqa: PLW0603 - one process answers one command line
    _log = log


def log() -> FileLog | None:
    """The current log; None if this process does not log."""
    return _log


def depends_on_more() -> None:
    """Note that the result depends on more than files and variables: a program, the time."""
    if _log is not None:
        _log.is_complete = False


def read(path: str | os.PathLike[str], most: int = -1) -> bytes:
    """The bytes of a file.

    Args:
        most: how many bytes from the beginning; all if negative.

    Raises:
        OSError: it cannot be opened, is not a regular file, or exceeds ``MAX_BYTES``.
        ValueError: the path contains a NUL.
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


def contents(path: str, most: int = -1) -> bytes | None:
    """The bytes of a file, as of `read`; None if it cannot be read."""
    try:
        return read(path, most)
    except (OSError, ValueError):
        return None


def state(path: str) -> os.stat_result:
    """``os.stat`` of a file; links are followed.

    Raises:
        OSError: it does not exist.
        ValueError: the path contains a NUL.
    """
    try:
        status = os.stat(path)
    except OSError:
        if _log is not None:
            _log.state("s", path, None)
        raise
    if _log is not None:
        _log.state("s", path, status)
    return status


def version(path: str) -> tuple[int, ...]:
    """Numbers that differ once a file has changed; nothing is noted, as its text is.

    Raises:
        OSError, ValueError: as of `state`.
    """
    status = os.stat(path)
    return status.st_dev, status.st_ino, status.st_size, status.st_mtime_ns


def exists(path: str) -> bool:
    return _mode(path) != 0


def is_file(path: str) -> bool:
    """True for a regular file or a link to one."""
    return S_ISREG(_mode(path))


def is_directory(path: str) -> bool:
    """True for a directory or a link to one."""
    return S_ISDIR(_mode(path))


def is_link(path: str) -> bool:
    """True for a symbolic link, even a broken one."""
    return S_ISLNK(_mode(path, follow=False))


def link_target(path: str) -> str:
    """The path that a symbolic link contains."""
    return os.readlink(path)


def has_name(path: str) -> bool:
    """True if the path exists, even as a broken link."""
    return _mode(path, follow=False) != 0


def names(directory: str) -> list[str]:
    """The names in a directory.

    Raises:
        OSError: it is not a directory, or not readable.
        ValueError: the path contains a NUL.
    """
    return [entry.name for entry in entries(directory)]


def names_or_empty(directory: str) -> list[str]:
    """The names in a directory; empty if it does not exist or is not readable."""
    try:
        return names(directory)
    except (OSError, ValueError):
        return []


def entries(directory: str) -> list[os.DirEntry[str]]:
    """The entries of a directory.

    Raises:
        OSError: it is not a directory, or not readable.
        ValueError: the path contains a NUL.
    """
    try:
        with os.scandir(directory) as scanned:
            inside = list(scanned)
    except OSError:
        if _log is not None:
            _log.listed(directory, None)
        raise
    if _log is not None:
        _log.listed(directory, inside)
    return inside


def walk(directory: str) -> Iterator[tuple[str, list[str], list[str]]]:
    """Like ``os.walk``: directories from the top, with the directories and files in each."""
    waiting = [directory]
    while waiting:
        parent = waiting.pop()
        try:
            inside = entries(parent)
        except OSError:
            continue
        links = {entry.name for entry in inside if entry.is_symlink()}
        directories: list[str] = []
        files: list[str] = []
        for entry in inside:
            is_inner = is_directory(entry.path) if entry.name in links else entry.is_dir()
            (directories if is_inner else files).append(entry.name)
        yield parent, directories, files
        inner = (name for name in reversed(directories) if name not in links)
        waiting += (os.path.join(parent, name) for name in inner)


def real(path: str) -> str:
    """Absolute path with all symbolic links resolved."""
    target = os.path.realpath(path)
    if _log is not None:
        _log.real(path, target)
    return target


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


def _mode(path: str, *, follow: bool = True) -> int:
    """``st_mode`` of a file or a link; 0 if it does not exist."""
    try:
        status = os.stat(path, follow_symlinks=follow)
    except (OSError, ValueError):
        status = None
    if _log is not None:
        _log.state("k" if follow else "l", path, status)
    return status.st_mode if status is not None else 0
