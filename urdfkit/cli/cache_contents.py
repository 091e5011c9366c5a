"""What lies in the cache."""

from __future__ import annotations

import os

from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.record import Record

#: The directories that urdfkit makes in that of the cache; it leaves others alone.
_OWN = ("meshes", "results")


class Contents(Record):
    """Files and directories of the cache."""

    files: list[str]  # the entries
    size: int  # of all, in bytes
    directories: list[str]  # that they are in, the innermost first


def contents() -> Contents:
    """What lies in the cache now."""
    files: list[str] = []
    directories: list[str] = []
    cache = cache_directory()
    for name in _OWN if cache else ():
        for parent, _, names in os.walk(os.path.join(cache or "", name), topdown=False):
            directories.append(parent)
            files += (os.path.join(parent, entry) for entry in names)
    return Contents(files, sum(map(_size, files)), directories)


def _size(path: str) -> int:
    try:
        return os.stat(path).st_size
    except OSError:  # another run has removed it
        return 0
