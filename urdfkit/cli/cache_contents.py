"""The contents of the cache."""

from __future__ import annotations

import os

from urdfkit.core.cache_directory import cache_directory
from urdfkit.core.record import Record

#: Subdirectories of the cache that urdfkit creates; others are not touched.
_OWN = ("meshes", "results")


class Contents(Record):
    """Files and directories of the cache."""

    files: list[str]  # the entries
    size: int  # total size in bytes
    directories: list[str]  # directories of the entries, innermost first


def contents() -> Contents:
    """The current contents of the cache."""
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
