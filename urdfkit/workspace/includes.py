"""Which xacro file includes a file; read from the text, nothing is expanded."""

import os
import re

from urdfkit.core import disk
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.packages import Packages

#: Bounds of the search; the largest public description package has 300 xacro files.
MAX_ENTRIES = 20_000
MAX_FILES = 2000
MAX_BYTES = 4 * 1024 * 1024
#: Includes of includes that are followed upwards.
MAX_DEPTH = 10

_SUFFIXES = (".xacro", ".urdf", ".gazebo", ".xml", ".trans")


def is_included(path: str, packages: Packages) -> bool:
    """True if another file of the package, or of the directory without one, includes a file.

    True as well if there are too many files to know: silence is then the safer answer.
    """
    return includer(path, packages) is not None


def includer(path: str, packages: Packages) -> str | None:
    """A file of the same package that includes a file; ``""`` if there are too many to search.

    Includes are compared by file name: their directories may be expressions. Of several files the
    nearest by directory counts: packages hold variants of a robot side by side. An ``<include>``
    without its prefix counts, and so does the default of an argument, by which husky and jackal
    are extended.
    """
    package = packages.enclosing(path)
    path = os.path.abspath(path)
    directory = package[1] if package else os.path.dirname(path)
    name = re.escape(os.path.basename(path).encode())
    pattern = re.compile(
        rb"""<(?:(?:xacro:)?include|xacro:arg)\b[^>]*[/"'\s]""" + name + rb"""[)"'\s]"""
    )
    found: list[str] = []
    entries = searched = 0
    for parent, directories, files in disk.walk(directory):
        deep_enough = package is None and parent != directory  # nothing says where to stop
        directories[:] = (
            [] if deep_enough else sorted(n for n in directories if not n.startswith("."))
        )
        entries += len(directories) + len(files)
        for file in sorted(files):
            if file.lower().endswith(_SUFFIXES) and (there := os.path.join(parent, file)) != path:
                searched += 1
                if pattern.search(read_head(there, MAX_BYTES)):
                    found.append(there)
        if entries > MAX_ENTRIES or searched > MAX_FILES:
            return ""
    return max(found, key=lambda there: len(os.path.commonpath((there, path))), default=None)


def top_includer(path: str, packages: Packages) -> str | None:
    """The file at the upper end of a chain of includes that ends at a file."""
    found, above = None, includer(path, packages)
    seen = {os.path.abspath(path)}
    while above and above not in seen and len(seen) <= MAX_DEPTH:
        seen.add(above)
        found, above = above, includer(above, packages)
    return found or above
