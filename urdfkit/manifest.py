"""The package.xml around a file: what the package is called, built with, and depends on."""

from __future__ import annotations

import os
import re

from urdfkit.packages import Packages
from urdfkit.record import Record

MAX_BYTES = 1024 * 1024

_COMMENT = re.compile(rb"<!--.*?-->", re.DOTALL)
_DEPENDENCY = re.compile(rb"<(\w*depend)\b[^>]*>\s*([\w.-]+)\s*</\1>")
_BUILD = re.compile(rb"<(?:buildtool_depend|build_type)\b[^>]*>\s*(ament|catkin)")


class Manifest(Record):
    """What a package.xml says.

    Attributes:
        path: of it.
        package: its name.
        dependencies: names of packages, of every kind of dependency.
        ros: 1 or 2 by the build system; None if it does not tell.
    """

    path: str
    package: str
    dependencies: frozenset[str]
    ros: int | None


def manifest_of(packages: Packages, path: str) -> Manifest | None:
    """The package.xml of the package that a file lies in; None outside of packages."""
    enclosing = packages.enclosing(path)
    if enclosing is None:
        return None
    name, folder = enclosing
    file = os.path.join(folder, "package.xml")
    try:
        with open(file, "rb") as opened:
            data = _COMMENT.sub(b"", opened.read(MAX_BYTES))
    except OSError:
        return None  # a rosbuild package
    build = _BUILD.search(data)
    return Manifest(
        file,
        name,
        frozenset(found[1].decode() for found in _DEPENDENCY.findall(data)),
        None if build is None else {b"catkin": 1, b"ament": 2}[build.group(1)],
    )
