"""Paths in machine-readable reports: services identify a file by its path in the repository."""

import os
from functools import lru_cache

from urdfkit.core import disk
from urdfkit.core.paths import is_within, upwards
from urdfkit.text.source import shown


def posix(path: str) -> str:
    """The shown path of a file, with forward slashes on every system."""
    return shown(path).replace(os.sep, "/")


def in_repository(path: str) -> str:
    """The path of a file in its repository, which is what GitHub and GitLab know of it.

    urdfkit may run in a part of the repository, and the repository may be one of a workspace, such
    as ``src/arm``.
    """
    try:
        here = os.getcwd()
    except OSError:  # it is deleted
        return posix(path)
    absolute = os.path.abspath(path)
    for start in (here, os.path.dirname(absolute)):
        top = _repository(start)
        if top and is_within(absolute, top):
            return os.path.relpath(absolute, top).replace(os.sep, "/")
    return posix(path)


@lru_cache  # asked for each finding
def _repository(directory: str) -> str:
    """The repository of a directory; empty if there is none."""
    tops = (at for at in upwards(directory) if disk.has_name(os.path.join(at, ".git")))
    return next(tops, "")
