"""Temporary directories; leftovers of killed processes are removed by the next process.

The process that uses a directory holds a lock on it, which the system releases when the process
ends. Windows cannot lock directories: there, leftovers stay.
"""

import os
import re
import shutil
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager

from urdfkit.core.atomic import temporary_name

if sys.platform != "win32":
    import fcntl

#: Names of scratch directories.
_PREFIX, _SUFFIX = "urdfkit-", ".tmp"
_NAME = re.compile(r"urdfkit-\w{8}\.tmp")


@contextmanager
def scratch() -> Iterator[str]:
    """An empty directory in the temporary directory of the system."""
    remove_abandoned()
    while True:
        path = tempfile.mkdtemp(_SUFFIX, _PREFIX)
        try:
            descriptor = _lock(path)
        except BlockingIOError:
            continue  # another process is removing it as abandoned
        if descriptor is not None:
            break  # otherwise that process has removed it
    try:
        yield path
    finally:
        _remove(path, descriptor)


@contextmanager
def workshop(path: str) -> Iterator[str]:
    """A directory for building a file or directory that is then moved to ``path``.

    Its name depends on ``path`` alone, so that a leftover of a killed process is reused; it may
    not be empty.

    Raises:
        BlockingIOError: another process uses it.
        OSError: it cannot be created.
    """
    directory = temporary_name(path, ".dir")
    descriptor = None
    while descriptor is None:
        try:
            os.mkdir(directory)
        except FileExistsError:
            pass
        descriptor = _lock(directory)
    try:
        yield directory
    finally:
        _remove(directory, descriptor)


def remove_abandoned() -> None:
    """Remove scratch directories of killed processes."""
    if sys.platform == "win32":
        return
    home = tempfile.gettempdir()
    for name in filter(_NAME.fullmatch, os.listdir(home)):
        path = os.path.join(home, name)
        try:
            descriptor = _lock(path)
        except OSError:  # in use, or of another user
            continue
        if descriptor is not None:
            if os.fstat(descriptor).st_uid == os.geteuid():
                shutil.rmtree(path, ignore_errors=True)
            os.close(descriptor)


def _lock(path: str) -> int | None:
    """Lock a directory until the returned descriptor is closed; None if it does not exist.

    Raises:
        OSError: it is locked, cannot be opened, or is not a directory.
    """
    if sys.platform == "win32":
        return -1
    try:
        descriptor = os.open(path, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW | os.O_CLOEXEC)
    except FileNotFoundError:
        return None
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        if os.path.samestat(os.fstat(descriptor), os.stat(path, follow_symlinks=False)):
            return descriptor
    except FileNotFoundError:
        pass
    except BaseException:
        os.close(descriptor)
        raise
    os.close(descriptor)
    return None


def _remove(path: str, descriptor: int) -> None:
    shutil.rmtree(path, ignore_errors=True)
    if descriptor >= 0:
        os.close(descriptor)
