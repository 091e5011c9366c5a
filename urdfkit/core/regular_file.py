"""Opening a file that anybody may have named, without waiting and without doing anything."""

from __future__ import annotations

import os
from errno import EINVAL, EISDIR
from stat import S_ISDIR, S_ISFIFO, S_ISREG, S_ISSOCK

TYPE_CHECKING = False  # ``typing`` takes longer to import than all that this does

if TYPE_CHECKING:
    from typing import BinaryIO

#: What a shell hands over, as in ``check <(xacro r.xacro)``: open already, and not waited for.
_HANDED_OVER = ("/dev/stdin", "/dev/fd/", "/proc/self/fd/")


def opened(path: str) -> BinaryIO:
    """A regular file, open for reading.

    Nothing else is opened: a pipe may wait for ever, a device never end, or do something.

    Raises:
        OSError: it cannot be opened, or is no regular file.
        ValueError: there is a NUL in its name.
    """
    return open(path, "rb", opener=_open_regular)


def _open_regular(path: str, flags: int) -> int:
    _require_regular(os.stat(path).st_mode, path)
    nonblocking = getattr(os, "O_NONBLOCK", 0)  # 0 on Windows
    descriptor = os.open(path, flags | nonblocking)
    try:
        _require_regular(os.fstat(descriptor).st_mode, path)  # it may be another one by now
        if nonblocking:
            os.set_blocking(descriptor, True)
    except BaseException:
        os.close(descriptor)
        raise
    return descriptor


def _require_regular(mode: int, path: str) -> None:
    if S_ISREG(mode) or (S_ISFIFO(mode) and path.startswith(_HANDED_OVER)):
        return
    if S_ISDIR(mode):
        raise IsADirectoryError(EISDIR, os.strerror(EISDIR), path)
    kind = "pipe" if S_ISFIFO(mode) else "socket" if S_ISSOCK(mode) else "device"
    raise OSError(EINVAL, f"is a {kind}, not a regular file", path)
