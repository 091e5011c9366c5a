"""Looking into files that may be anything."""

from urdfkit.core import disk


def read_head(path: str, most: int) -> bytes:
    """The first bytes of a file; none of what cannot be read, or is a pipe, which may never end."""
    try:
        if not disk.is_file(path):
            return b""
        return disk.read(path, most)
    except (OSError, ValueError):  # ValueError: a NUL in the name
        return b""
