"""Opens regular files only: a path from a model may lead to a pipe or a device."""

from __future__ import annotations

import os
from errno import EINVAL, EISDIR
from stat import S_ISDIR, S_ISFIFO, S_ISREG, S_ISSOCK

TYPE_CHECKING = False  # importing ``typing`` would take longer than this module

if TYPE_CHECKING:
    from typing import BinaryIO

#: Pipes that the shell has opened, as in ``check <(xacro r.xacro)``.
_HANDED_OVER = ("/dev/stdin", "/dev/fd/", "/proc/self/fd/")


def opened(path: str) -> BinaryIO:
    """Open a regular file for reading.

    Opening a pipe may block for ever; reading a device may never end, or have side effects.

    Raises:
        OSError: it cannot be opened, or is not a regular file.
        ValueError: the path contains a NUL.
    """
    return open(path, "rb", opener=_open_regular)


def _open_regular(path: str, flags: int) -> int:
    _require_regular(os.stat(path).st_mode, path)
    nonblocking = getattr(os, "O_NONBLOCK", 0)  # 0 on Windows
    descriptor = os.open(path, flags | nonblocking)
    try:
        _require_regular(os.fstat(descriptor).st_mode, path)  # it may have been replaced
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
