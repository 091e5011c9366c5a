"""Search for the xacro file that includes a file, in the text without expansion."""

import os
import re

from urdfkit.core import disk
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.packages import Packages

#: Bounds of the search; the largest public description package has 300 xacro files.
MAX_ENTRIES = 20_000
MAX_FILES = 2000
MAX_BYTES = 4 * 1024 * 1024
#: Most nested includes that are followed upwards.
MAX_DEPTH = 10

#: Directories above a file in which a xacro may include it by an argument.
_MAX_LEVELS = 3
_DECLARED = rb"""<xacro:arg\b[^<>]*?\bname\s*=\s*["']([^"']+)["']"""
_OF_ARGUMENTS = rb"""<xacro:include\b[^<>]*[/"']\$\(arg\s+\w+\s*\)\.urdf["']"""

_SUFFIXES = (".xacro", ".urdf", ".gazebo", ".xml", ".trans")


def is_included(path: str, packages: Packages) -> bool:
    """True if another file of the package (or directory, without a package) includes a file.

    Also True if there are too many files to search: a missed finding is better than a false one.
    """
    return includer(path, packages) is not None


def is_named_by_arguments(path: str, arguments: set[str], packages: Packages) -> bool:
    """True if a xacro above a file in its workspace may include it, and declares its arguments.

    Such an include has a name that is an argument: ``$(arg tool_dir)/$(arg tool).urdf``.
    """
    directory, top = os.path.dirname(os.path.abspath(path)), packages.workspace(path)
    for _ in range(_MAX_LEVELS):
        if directory == top:
            break
        directory = os.path.dirname(directory)
        for name in sorted(disk.names_or_empty(directory)):
            text = read_head(os.path.join(directory, name), MAX_BYTES) if _is_xacro(name) else b""
            declared = {word.decode("utf-8", "replace") for word in re.findall(_DECLARED, text)}
            if arguments and arguments <= declared and re.search(_OF_ARGUMENTS, text):
                return True
    return False


def _is_xacro(name: str) -> bool:
    return name.lower().endswith(".xacro")


def includer(path: str, packages: Packages) -> str | None:
    """The file of the same package that includes a file; ``""`` if there are too many to search.

    Of several files the one in the nearest directory is returned: packages contain several variants
    of a robot.
    """
    found = includers(path, packages)
    if found is None:
        return ""
    path = os.path.abspath(path)
    return max(found, key=lambda file: len(os.path.commonpath((file, path))), default=None)


def includers(path: str, packages: Packages) -> list[str] | None:
    """The files of the same package that include a file; None if there are too many to search.

    Includes are compared by file name: their directories may be expressions. An ``<include>``
    without its prefix counts, and so does the default of an argument, which extends husky and
    jackal.
    """
    package = packages.enclosing(path)
    path = os.path.abspath(path)
    directory = package[1] if package else os.path.dirname(path)
    own_name = os.path.basename(path).encode()
    before = rb"""<(?:(?:xacro:)?include|xacro:arg)\b[^<>]*[/"'\s]"""
    pattern = before + re.escape(own_name) + rb"""[)"'\s]"""
    found: list[str] = []
    entries = searched = 0
    for parent, directories, files in disk.walk(directory):
        is_too_deep = package is None and parent != directory  # a package would bound the search
        directories[:] = (
            [] if is_too_deep else sorted(n for n in directories if not n.startswith("."))
        )
        entries += len(directories) + len(files)
        for name in sorted(files):
            if name.lower().endswith(_SUFFIXES) and (file := os.path.join(parent, name)) != path:
                searched += 1
                text = read_head(file, MAX_BYTES)
                if own_name in text and re.search(pattern, text):
                    found.append(file)
        if entries > MAX_ENTRIES or searched > MAX_FILES:
            return None
    return found


def top_includer(path: str, packages: Packages) -> str | None:
    """The outermost file in a chain of includes that ends at a file; None if there is none."""
    top, parent = None, includer(path, packages)
    visited = {os.path.abspath(path)}
    while parent and parent not in visited and len(visited) <= MAX_DEPTH:
        visited.add(parent)
        top, parent = parent, includer(parent, packages)
    return top or parent
