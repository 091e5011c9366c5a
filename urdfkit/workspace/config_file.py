"""The configuration file that holds for a file; most robots have none, and nothing more is read."""

import os

from urdfkit.core import disk
from urdfkit.core.paths import upwards

FILES = ("urdfkit.toml", "pyproject.toml")


def nearest(start: str) -> str | None:
    """Path of the nearest configuration upwards of a file or directory, or None."""
    for directory in upwards(os.path.abspath(start)):
        for name in FILES:
            path = os.path.join(directory, name)
            if disk.is_file(path) and (name != "pyproject.toml" or _mentions_us(path)):
                return path
    return None


def _mentions_us(path: str) -> bool:
    try:
        return b"[tool.urdfkit" in disk.read(path)
    except OSError:
        return False
