"""Looking into files that may be anything."""

from __future__ import annotations

import os


def read_head(path: str, most: int) -> bytes:
    """The first bytes of a file; none of what cannot be read, or is a pipe, which may never end."""
    try:
        if not os.path.isfile(path):
            return b""
        with open(path, "rb", buffering=0) as file:
            return file.read(most)
    except (OSError, ValueError):  # ValueError: a NUL in the name
        return b""
