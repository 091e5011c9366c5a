"""The package.xml around a file: what the package is called, built with, and depends on."""

from __future__ import annotations

import os
import re

from urdfkit.record import Record
from urdfkit.workspace.resolve import Resolver

MAX_BYTES = 1024 * 1024

_COMMENT = rb"(?s)<!--.*?-->"
_DEPENDENCY = rb"<(\w*depend)\b[^>]*>\s*([\w.-]+)\s*</\1>"
_BUILD = rb"<(?:buildtool_depend|build_type)\b[^>]*>\s*(ament|catkin)"


class Manifest(Record):
    """What a package.xml says.

    Attributes:
        path: of it.
        package: its name.
        data: its text without comments.
    """

    path: str
    package: str
    data: bytes

    @property
    def dependencies(self) -> frozenset[str]:
        """Names of packages, of every kind of dependency."""
        return frozenset(name.decode() for _, name in re.findall(_DEPENDENCY, self.data))

    @property
    def ros(self) -> int | None:
        """1 or 2 by the build system; None if it does not tell."""
        build = re.search(_BUILD, self.data)
        return None if build is None else {b"catkin": 1, b"ament": 2}[build.group(1)]


def manifest_of(resolver: Resolver, path: str) -> Manifest | None:
    """The package.xml of the package that a file lies in; None outside of packages."""
    enclosing = resolver.packages.enclosing(path)
    if enclosing is None:
        return None
    name, folder = enclosing
    file = os.path.join(folder, "package.xml")
    data = resolver.text(file)
    if data is None:
        try:
            with open(file, "rb") as opened:
                data = opened.read(MAX_BYTES)
        except OSError:
            return None  # a rosbuild package
    return Manifest(file, name, re.sub(_COMMENT, b"", data))
