"""Paths in machine-readable reports: services identify a file by its path in the repository."""

import os

from urdfkit.text.source import shown


def posix(path: str) -> str:
    """The shown path of a file, with forward slashes on every system."""
    return shown(path).replace(os.sep, "/")
