"""Directories for a while; one that a kill leaves is removed by the next process that needs one.

The system locks each for the process that uses it, until that ends in whatever way. On Windows,
which locks no directories, what a kill leaves stays.
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

#: Of directories where the system has its temporary files.
_PREFIX, _SUFFIX = "urdfkit-", ".tmp"
_NAME = re.compile(r"urdfkit-\w{8}\.tmp")


@contextmanager
def scratch() -> Iterator[str]:
    """An empty directory where the system has its temporary files."""
    remove_abandoned()
    while True:
        path = tempfile.mkdtemp(_SUFFIX, _PREFIX)
        try:
            descriptor = _lock(path)
        except BlockingIOError:
            continue  # another process takes it for abandoned, and removes it
        if descriptor is not None:
            break  # else that process was still faster
    try:
        yield path
    finally:
        _remove(path, descriptor)


@contextmanager
def workshop(path: str) -> Iterator[str]:
    """A directory next to a file or directory that is made in it, and then takes its name.

    It always has the same name: after a kill it holds what the other process was about.

    Raises:
        BlockingIOError: another process uses it.
        OSError: it cannot be made.
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
    """Remove the scratch directories of processes that have ended without doing so."""
    if sys.platform == "win32":
        return
    home = tempfile.gettempdir()
    for name in filter(_NAME.fullmatch, os.listdir(home)):
        path = os.path.join(home, name)
        try:
            descriptor = _lock(path)
        except OSError:  # in use, or somebody else's
            continue
        if descriptor is not None:
            if os.fstat(descriptor).st_uid == os.geteuid():
                shutil.rmtree(path, ignore_errors=True)
            os.close(descriptor)


def _lock(path: str) -> int | None:
    """Lock a directory until what is returned is closed; None if it is gone.

    Raises:
        OSError: it is locked, may not be opened, or is none.
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
