"""Paths in reports that services read: they know files by their place in the repository."""

import os

from urdfkit.text.source import shown


def posix(path: str) -> str:
    """A path as people are shown it, with forward slashes on every system."""
    return shown(path).replace(os.sep, "/")
