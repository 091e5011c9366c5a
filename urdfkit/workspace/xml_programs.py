"""The words that programs of a workspace name as strings, such as tags of their own in XML."""

import os
import re
from collections.abc import Collection, Iterable, Iterator
from itertools import islice

from urdfkit.text.file_kinds import is_launch
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver

#: Bounds of the search.
MAX_FILES, MAX_BYTES = 1000, 200_000

_MANIFEST = os.sep + "package.xml"
_SUFFIXES = (".cpp", ".cc", ".cxx", ".h", ".hpp", ".py")
#: What a program that reads XML names.
_READS_XML = rb"tinyxml|firstchildelement|elementtree|minidom|lxml|pugi"


def readers_of(tags: Iterable[str], near: str, resolver: Resolver) -> dict[str, str]:
    """The source files of programs that read XML and name a tag as a string, by tag.

    Programs are looked for in the package of a file, in those next to it, such as the driver of a
    robot, and in those that its ``package.xml`` names, if their directories are called so.

    Args:
        near: path of the file; for one in no package nothing is searched.
        resolver: finds the workspace, and knows which files may be read.
    """
    found: dict[str, str] = {}
    for path, data, named in _naming(tags, rb"[./]*", near, resolver):
        if not named <= found.keys() and re.search(_READS_XML, data.lower()):
            found = dict.fromkeys(named, path) | found
    return found


def named_in_programs(words: Collection[str], near: str, resolver: Resolver) -> set[str]:
    """Those of some words that a program of a workspace, not a launch file, names as a string.

    Args:
        words: such as the names of frames.
        near: path of a file in the workspace that is searched.
        resolver: finds the workspace, and knows which files may be read.
    """
    if not words:
        return set()
    found = _naming(words, b"/?", near, resolver)
    return {word for path, _, named in found if not is_launch(path) for word in named}


def _naming(
    words: Iterable[str], before: bytes, near: str, resolver: Resolver
) -> Iterator[tuple[str, bytes, set[str]]]:
    """The source files that name words as strings, their text, and these words."""
    encoded = [word.encode() for word in words]
    quoted = rb"""(["'])""" + before + b"(" + b"|".join(map(re.escape, encoded)) + rb""")\1"""
    for path in filter(resolver.admits, islice(_sources(near, resolver), MAX_FILES)):
        data = read_head(path, MAX_BYTES)
        if not any(word in data for word in encoded):
            continue  # most files; then the pattern need not be compiled
        if named := {match[2].decode() for match in re.finditer(quoted, data)}:
            yield path, data, named


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
