"""Writing files so that no reader ever sees half of one, and no kill leaves one."""

import os
import stat
import sys
import time
import zlib
from collections.abc import Iterable
from errno import EEXIST, ENXIO, EWOULDBLOCK
from typing import BinaryIO

from urdfkit.core import disk, limits
from urdfkit.errors import UnwritableFile

if sys.platform != "win32":
    import fcntl

#: Seconds to wait for another process that writes the same file.
MAX_WAIT = 10.0


def write(
    path: str | os.PathLike[str],
    data: bytes | Iterable[bytes],
    *,
    before: bytes | None = None,
    durable: bool = True,
) -> None:
    """Write a file whole or not at all; one that exists keeps its permissions.

    The bytes go to a new file in the same directory, which then takes the name. A link stays one.
    What is no regular file, such as ``/dev/stderr``, is written to directly.

    Args:
        data: all that it is to hold, or its parts.
        before: what it must hold up to now, so that nothing is lost that another one wrote.
        durable: wait until the disk has it; a cache does without.

    Raises:
        UnwritableFile: a missing directory, permission or space; or it holds something else.
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
    """Make a directory and those above it, where they are missing.

    Raises:
        UnwritableFile: a file is in the way, or permission is missing.
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
                raise UnwritableFile(f"{path}: it has changed meanwhile; run it again")
            file.writelines(parts)
            file.flush()
            if durable:
                os.fsync(file.fileno())
            if mode is not None:
                os.chmod(temporary, stat.S_IMODE(mode))
            if sys.platform == "win32":
                file.close()  # there, what is open cannot be renamed
            os.replace(temporary, path)
        except BaseException:
            if sys.platform == "win32":
                file.close()
            os.unlink(temporary)  # as long as nobody else can have claimed it
            raise


def temporary_name(path: str, suffix: str) -> str:
    """What is written first; always the same, so that what a kill leaves is used again.

    Its name is short, whatever that of the file is, and nobody else has one like it.
    """
    directory, name = os.path.split(path)
    process = f"-{os.getpid()}" if sys.platform == "win32" else ""
    return os.path.join(directory, f".urdfkit-{zlib.crc32(os.fsencode(name)):08x}{process}{suffix}")


def _claimed(temporary: str) -> BinaryIO:
    """An empty file of this name that nobody else writes until it is closed, even by a kill."""
    if sys.platform == "win32":
        return open(temporary, "xb")
    # Neither a link nor a pipe that somebody has put there is followed.
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
            # Else who had it has given it the other name meanwhile.
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
    """Write to what is no regular file, unless it is a pipe that nobody reads."""
    nonblocking = getattr(os, "O_NONBLOCK", 0)  # 0 on Windows
    descriptor = os.open(path, os.O_WRONLY | nonblocking)
    with os.fdopen(descriptor, "wb") as file:
        if nonblocking:
            os.set_blocking(descriptor, True)
        file.writelines(parts)


def _why_unwritable(path: str | os.PathLike[str], error: OSError) -> str:
    """The reason, and how to fix it."""
    directory = os.path.dirname(path) or "."
    if os.path.isdir(path):
        return "is a directory; pass a file in it"
    if not os.path.isdir(directory):
        return f"no such directory '{directory}'; create it first"
    if error.errno == ENXIO:
        return "cannot be written: it is a pipe or socket that nobody reads"
    if error.errno == EWOULDBLOCK:
        return "cannot be written: another process is writing it"
    if isinstance(error, FileExistsError):
        return f"cannot be written: {error.filename} is in the way; remove it"
    return f"cannot be written: {error.strerror or error}"
