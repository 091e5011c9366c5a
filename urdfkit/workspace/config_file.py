"""Search for the configuration file of a robot; most robots have none."""

import os
import re

from urdfkit.core import disk
from urdfkit.core.paths import upwards

FILES = ("urdfkit.toml", "pyproject.toml")
#: At the start of a line, after a byte-order mark: a section in a comment is none.
_SECTION = rb"(?m)^(?:\xef\xbb\xbf)?[ \t]*\[+[ \t]*tool\.urdfkit\b"


def nearest(start: str) -> str | None:
    """Path of the nearest configuration file, searching upwards; None if there is none."""
    for directory in upwards(os.path.abspath(start)):
        for name in FILES:
            path = os.path.join(directory, name)
            if disk.is_file(path) and (name != "pyproject.toml" or _has_section(path)):
                return path
    return None


def _has_section(path: str) -> bool:
    return re.search(_SECTION, disk.contents(path) or b"") is not None
