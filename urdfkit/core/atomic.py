"""Atomic writes: no reader sees a partial file, and a killed process leaves none."""

import os
import stat
import sys
import time
import zlib
from collections.abc import Iterable
from errno import EEXIST, ENXIO, EWOULDBLOCK

from urdfkit.core import disk, limits
from urdfkit.core.static_typing import BinaryIO
from urdfkit.errors import FileChanged, UnwritableFile

if sys.platform != "win32":
    import fcntl

#: Seconds to wait while another process writes the same file.
MAX_WAIT = 10.0


def write(
    path: str | os.PathLike[str],
    data: bytes | Iterable[bytes],
    *,
    before: bytes | None = None,
    durable: bool = True,
) -> None:
    """Write a file completely or not at all; an existing file keeps its permissions.

    The bytes go to a temporary file in the same directory, which is then renamed. A symbolic link
    is followed. A path that is not a regular file, such as ``/dev/stderr``, is written directly.

    Args:
        data: the new contents, as a whole or in parts.
        before: the expected present contents; protects what another process has written since.
        durable: wait until the data is on disk; a cache need not.

    Raises:
        UnwritableFile: a directory, a permission or space is missing.
        FileChanged: the present contents are not ``before``.
    """
    if durable:
        limits.end_time()
    try:
        parts = (data,) if isinstance(data, bytes) else data
        _write(os.path.realpath(path), parts, before, durable=durable)
    except OSError as error:
        raise UnwritableFile(f"{os.fspath(path)}: {_why_unwritable(path, error)}") from error
    except ValueError as error:  # a NUL in the name
        raise UnwritableFile(f"{os.fspath(path)!r}: {error}") from error


def make_directory(path: str | os.PathLike[str]) -> None:
    """Create a directory and its missing parents.

    Raises:
        UnwritableFile: a file has that name, or permission is missing.
    """
    try:
        os.makedirs(path, exist_ok=True)
    except (OSError, ValueError) as error:
        reason = getattr(error, "strerror", None) or error
        raise UnwritableFile(
            f"{os.fspath(path)}: cannot create this directory: {reason}"
        ) from error


def _write(path: str, parts: Iterable[bytes], before: bytes | None, *, durable: bool) -> None:
    try:
        mode = os.stat(path).st_mode
    except FileNotFoundError:
        mode = None
    if mode is not None and not stat.S_ISREG(mode):
        _write_to_device(path, parts)
        return
    temporary = temporary_name(path, ".tmp")
    with _claimed(temporary) as file:
        try:
            if before is not None and disk.read(path) != before:
                raise FileChanged(path)
            file.writelines(parts)
            file.flush()
            if durable:
                os.fsync(file.fileno())
            if mode is not None:
                os.chmod(temporary, stat.S_IMODE(mode))
            if sys.platform == "win32":
                file.close()  # Windows cannot rename an open file
            os.replace(temporary, path)
        except BaseException:
            if sys.platform == "win32":
                file.close()
            os.unlink(temporary)  # while the lock is held: no other process can have claimed it
            raise


def temporary_name(path: str, suffix: str) -> str:
    """Path of the temporary file for a file.

    It is the same each time, so that a leftover of a killed process is reused, and short even if
    the name of the file is long.
    """
    directory, name = os.path.split(path)
    process = f"-{os.getpid()}" if sys.platform == "win32" else ""
    return os.path.join(directory, f".urdfkit-{zlib.crc32(os.fsencode(name)):08x}{process}{suffix}")


def _claimed(temporary: str) -> BinaryIO:
    """An empty file, locked until it is closed; the system unlocks it if the process is killed."""
    if sys.platform == "win32":
        return open(temporary, "xb")
    # A symbolic link or a pipe that somebody has put there must not be opened.
    flags = os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW | os.O_NONBLOCK | os.O_CLOEXEC
    end = time.monotonic() + MAX_WAIT
    while True:
        file = os.fdopen(os.open(temporary, flags, 0o666), "wb")
        try:
            state = os.fstat(file.fileno())
            if not stat.S_ISREG(state.st_mode) or state.st_nlink > 1:
                raise FileExistsError(EEXIST, os.strerror(EEXIST), temporary)
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            if _is_at(file, temporary):
                file.truncate()
                return file
            # Otherwise the process that held the lock has renamed the file.
        except BlockingIOError:
            if time.monotonic() > end:
                file.close()
                raise
            time.sleep(0.01)
        except BaseException:
            file.close()
            raise
        file.close()


def _is_at(file: BinaryIO, path: str) -> bool:
    try:
        return os.path.samestat(os.fstat(file.fileno()), os.stat(path, follow_symlinks=False))
    except FileNotFoundError:
        return False


def _write_to_device(path: str, parts: Iterable[bytes]) -> None:
    """Write to a device or a pipe; fails for a pipe without a reader."""
    nonblocking = getattr(os, "O_NONBLOCK", 0)  # 0 on Windows
    descriptor = os.open(path, os.O_WRONLY | nonblocking)
    with os.fdopen(descriptor, "wb") as file:
        if nonblocking:
            os.set_blocking(descriptor, True)
        file.writelines(parts)


def _why_unwritable(path: str | os.PathLike[str], error: OSError) -> str:
    """The reason of an error, and how to fix it."""
    directory = os.path.dirname(path) or "."
    if os.path.isdir(path):
        return "is a directory; pass a file in it"
    if not os.path.isdir(directory):
        return f"no such directory '{directory}'; create it first"
    if error.errno == ENXIO:
        return "cannot be written: it is a pipe or socket without a reader"
    if error.errno == EWOULDBLOCK:
        return "cannot be written: another process is writing it"
    if isinstance(error, FileExistsError):
        return f"cannot be written: {error.filename} exists; remove it"
    return f"cannot be written: {error.strerror or error}"
