"""Bounded reading of files of any kind."""

import os

from urdfkit.core import disk


def read_head(path: str, most: int) -> bytes:
    """The first bytes of a file; empty if it is unreadable or not a regular file."""
    return disk.contents(path, most) or b""


def is_inside(path: str) -> bool:
    """True for a relative path that does not leave its directory."""
    return not os.path.isabs(path) and ".." not in path.split("/")
