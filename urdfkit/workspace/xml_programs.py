"""The words that programs of a workspace look for in XML files, such as tags of their own."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING

from urdfkit.workspace.file_head import read_head

if TYPE_CHECKING:
    from urdfkit.workspace.resolve import Resolver

#: Bounds of the search.
MAX_FILES, MAX_BYTES = 1000, 200_000

_MANIFEST = os.sep + "package.xml"
_SUFFIXES = (".cpp", ".cc", ".cxx", ".h", ".hpp", ".py")
#: What a program that reads XML names.
_READS_XML = re.compile(rb"tinyxml|FirstChildElement|ElementTree|minidom|lxml|pugi", re.IGNORECASE)


def readers_of(tags: Iterable[str], near: str, resolver: Resolver) -> dict[str, str]:
    """The source files of programs that read XML and name a tag as a string, by tag.

    Programs are looked for in the packages of a workspace, for a file in one of them.

    Args:
        near: path of a file in the workspace that is searched.
        resolver: finds the workspace, and knows which files may be read.
    """
    words = b"|".join(re.escape(tag.encode()) for tag in tags)
    quoted = re.compile(rb"""(["'])[./]*(""" + words + rb""")\1""")
    found: dict[str, str] = {}
    for path in filter(resolver.admits, islice(_sources(near, resolver), MAX_FILES)):
        data = read_head(path, MAX_BYTES)
        named = {match[2].decode() for match in quoted.finditer(data)} - found.keys()
        if named and _READS_XML.search(data):
            found.update(dict.fromkeys(named, path))
    return found


def _sources(near: str, resolver: Resolver) -> Iterator[str]:
    """The source files in the packages of a workspace."""
    if not resolver.packages.enclosing(near):
        return
    files = resolver.directories.walk(resolver.packages.workspace(near))
    packages = tuple(path[: 1 - len(_MANIFEST)] for path in files if path.endswith(_MANIFEST))
    for path in files:
        if path.endswith(_SUFFIXES) and path.startswith(packages):
            yield path
