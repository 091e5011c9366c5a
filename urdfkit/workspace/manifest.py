"""The package.xml around a file: what the package is called, built with, and depends on."""

from __future__ import annotations

import os
import re

from urdfkit.record import Record
from urdfkit.workspace.resolve import Resolver

MAX_BYTES = 1024 * 1024

_COMMENT = rb"(?s)<!--.*?(?:-->|\Z)"
_DEPENDENCY = rb"<(\w*depend)\b[^>]*>\s*([\w.-]+)\s*</\1>"
_BUILD = rb"<(?:buildtool_depend|build_type)\b[^>]*>\s*(ament|catkin)"


#: Tags that every package.xml has.
REQUIRED = ("name", "version", "description", "maintainer", "license")
#: The other tags that every format has, and those of single formats.
_OPTIONAL = frozenset(
    "author build_depend buildtool_depend conflict export replace test_depend url".split()
)
_SINCE_2 = frozenset(
    "build_export_depend buildtool_export_depend depend doc_depend exec_depend".split()
)
_BY_FORMAT = {
    "1": frozenset(("run_depend",)),
    "2": _SINCE_2,
    "3": _SINCE_2 | {"group_depend", "member_of_group"},
}


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


def known_tags(number: str | None) -> frozenset[str]:
    """The tags of a format, which is 1 where none is written; none for an unknown format."""
    own = _BY_FORMAT.get(number or "1")
    return own.union(REQUIRED, _OPTIONAL) if own else frozenset()


def beside(path: str) -> str | None:
    """The package.xml around a file, whatever is in it."""
    folder = os.path.dirname(os.path.abspath(path))
    while True:
        file = os.path.join(folder, "package.xml")
        if os.path.isfile(file):
            return file
        folder, below = os.path.dirname(folder), folder
        if folder == below:
            return None
