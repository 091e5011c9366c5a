"""Which xacro files of a package include a file; read from the text, nothing is expanded."""

from __future__ import annotations

import os
import re

#: Bounds of the search; the largest public description package has 300 xacro files.
MAX_FILES = 2000
MAX_BYTES = 4 * 1024 * 1024

_SUFFIXES = (".xacro", ".urdf", ".gazebo", ".xml", ".trans")


def is_included(path: str, folder: str) -> bool:
    """True if a file below ``folder`` seems to include the file ``path``.

    Includes are compared by file name: their folders may be expressions.
    """
    name = re.escape(os.path.basename(path).encode())
    pattern = re.compile(rb"""<xacro:include\b[^>]*[/"']""" + name + rb"""["']""")
    searched = 0
    for parent, folders, files in os.walk(folder):
        folders[:] = [name for name in folders if not name.startswith(".")]
        for file in files:
            if file.endswith(_SUFFIXES):
                searched += 1
                if searched > MAX_FILES:
                    return True  # not known: silence is the safer answer
                if pattern.search(_head(os.path.join(parent, file))):
                    return True
    return False


def _head(path: str) -> bytes:
    try:
        with open(path, "rb") as file:
            return file.read(MAX_BYTES)
    except OSError:
        return b""
