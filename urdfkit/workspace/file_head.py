"""Bounded reading of files of any kind."""

from urdfkit.core import disk


def read_head(path: str, most: int) -> bytes:
    """The first bytes of a file; empty if it is unreadable or not a regular file."""
    try:
        if not disk.is_file(path):
            return b""
        return disk.read(path, most)
    except (OSError, ValueError):  # ValueError: a NUL in the name
        return b""
