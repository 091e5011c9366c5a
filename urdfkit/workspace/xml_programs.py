"""The words that programs of a workspace look for in XML files, such as tags of their own."""

from __future__ import annotations

import re
from itertools import islice
from typing import TYPE_CHECKING

from urdfkit.workspace.file_head import read_head

if TYPE_CHECKING:
    from urdfkit.workspace.resolve import Resolver

#: Bounds of the search.
MAX_FILES, MAX_BYTES = 1000, 200_000

_SUFFIXES = (".cpp", ".cc", ".cxx", ".h", ".hpp", ".py")
#: What a program that reads XML names.
_READS_XML = re.compile(rb"tinyxml|FirstChildElement|ElementTree|minidom|lxml|pugi", re.IGNORECASE)


def reader_of(tag: str, near: str, resolver: Resolver) -> str | None:
    """The source file of a program that reads XML and names a tag as a string; None without one.

    Args:
        tag: of an element.
        near: path of a file in the workspace that is searched.
        resolver: finds the workspace, and knows which files may be read.
    """
    directory = resolver.packages.workspace(near)
    sources = (p for p in resolver.directories.walk(directory) if p.endswith(_SUFFIXES))
    quoted = re.compile(rb"""(["'])(?:[./]*)""" + re.escape(tag.encode()) + rb"\1")
    for path in filter(resolver.admits, islice(sources, MAX_FILES)):
        data = read_head(path, MAX_BYTES)
        if quoted.search(data) and _READS_XML.search(data):
            return path
    return None
