"""Paths in reports that services read: they know files by their place in the repository."""

from __future__ import annotations

import os


def relative(path: str) -> str:
    """A path from the current folder, which a service takes for that of the repository."""
    try:
        path = os.path.relpath(path)
    except (OSError, ValueError):  # the current folder is gone; another drive
        path = os.path.abspath(path)
    return path.replace(os.sep, "/")
