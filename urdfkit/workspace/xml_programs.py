"""The words that programs of a workspace look for in XML files, such as tags of their own."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable, Iterator
from itertools import islice
from typing import TYPE_CHECKING

from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.manifest import manifest_of

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

    Programs are looked for in the package of a file, in those next to it, such as the driver of a
    robot, and in those that its ``package.xml`` names, if their directories are called so.

    Args:
        near: path of the file; for one in no package nothing is searched.
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
    """The source files in the packages that are searched for a file."""
    packages, manifest = resolver.packages, manifest_of(resolver, near)
    if manifest is None:
        return
    own = os.path.dirname(manifest.path)
    around = os.path.dirname(own)
    tops = [around if packages.searches(around, near) else own]
    for name in sorted(manifest.dependencies):
        tops += packages.siblings_named(name, near)
    files = dict.fromkeys(path for top in tops for path in resolver.directories.walk(top))
    directories = tuple(path[: 1 - len(_MANIFEST)] for path in files if path.endswith(_MANIFEST))
    for path in files:
        if path.endswith(_SUFFIXES) and path.startswith(directories):
            yield path
