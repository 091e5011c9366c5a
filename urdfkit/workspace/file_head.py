"""Bounded reading of files of any kind."""

import os

from urdfkit.core import disk

#: Longer files, such as lists and build files, are not written by people.
MAX_BYTES = 1024 * 1024


def read_head(path: str, most: int = MAX_BYTES) -> bytes:
    """The first bytes of a file; empty if it is unreadable or not a regular file."""
    return disk.contents(path, most) or b""


def head_text(path: str, most: int = MAX_BYTES) -> str:
    """The text in the first bytes of a file, which may cut a character at the end."""
    return read_head(path, most).decode("utf-8", "replace")


def is_inside(path: str) -> bool:
    """True for a relative path that does not leave its directory."""
    return not os.path.isabs(path) and ".." not in path.split("/")
