"""Search for words in programs of a workspace, such as the XML tags that they read."""

import os
import re
from collections.abc import Collection, Iterable, Iterator
from functools import lru_cache
from itertools import islice

from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.resolve import Resolver

#: Bounds of the search.
MAX_FILES, MAX_BYTES = 1000, 200_000
_MOST_OF_PROGRAMS = 20_000_000  # bytes of all programs together

_MANIFEST = os.sep + "package.xml"
_SUFFIXES = (".cpp", ".cc", ".cxx", ".h", ".hpp", ".py")
#: Names of XML libraries and functions.
_READS_XML = rb"tinyxml|firstchildelement|elementtree|minidom|lxml|pugi"
#: Words in programs that publish messages of types that they learn at run time.
_OF_ANY_TYPE = rb"get_message|[Gg]eneric|rosbag|importlib|ShapeShifter"
#: Where a program in Python names a type of messages without publishing or reading them: imports
#: without a new name, signatures, and comments.
_NAMES = (
    rb"(?m)^[ \t]*from[ \t]+\w+\.msg[ \t]+import[ \t]+(?![^()\n]*\bas\b)[\w, \t]*$"
    rb"|^[ \t]*from[ \t]+\w+\.msg[ \t]+import[ \t]*\((?![^()]*\bas\b)[\w\s,]*\)"
    rb"|\bdef[ \t]+\w+\([^()]*\)"
    rb"|^[ \t]*#.*$"
)
_NOTHING = rb"(?!)"
#: What follows a word in a message for the user, and not a type in Python.
_GOES_ON = rb" (?!(?:and|as|else|for|if|in|is|not|or)\b)[a-z]"
_TYPE = rb"\(\s*(?:self,\s*)?(?:[\w.]+\.)?\w+,"
#: What does not count in a search for programs that publish them: also where one reads them; and
#: in one for programs that read them: also where one makes and publishes them.
_NOT_PUBLISHED = _NAMES + rb"|\b(?:create_subscription|Subscriber|Subscription)" + _TYPE
_NOT_READ = _NAMES + rb"|\b(?:create_publisher|Publisher)" + _TYPE + rb"|\b[A-Z]\w*\("


def xml_readers(tags: Iterable[str], near: str, resolver: Resolver) -> dict[str, str]:
    """The source files of programs that read XML and contain a tag as a string, by tag.

    The package of a file is searched, the packages next to it, such as the driver of a robot, and
    the dependencies in its ``package.xml``, if their directories have these names.

    Args:
        near: path of the file; a file without a package is not searched for.
        resolver: finds the workspace, and decides which files may be read.
    """
    readers: dict[str, str] = {}
    for path, data, strings in _files_with_strings(tags, rb"[./]*", near, resolver):
        if not strings <= readers.keys() and re.search(_READS_XML, data.lower()):
            readers = dict.fromkeys(strings, path) | readers
    return readers


def strings_in_programs(
    words: Collection[str], near: str, resolver: Resolver, containing: bytes = b""
) -> set[str]:
    """The words that a program of a workspace, not a launch file, contains as a string.

    Args:
        words: such as the names of frames.
        near: path of a file in the workspace that is searched.
        resolver: finds the workspace, and decides which files may be read.
        containing: a regular expression; only files that it matches count.
    """
    if not words:
        return set()
    files = _files_with_strings(words, b"/?", near, resolver)
    return {
        word
        for path, data, strings in files
        if not is_launch(path) and re.search(containing, data)
        for word in strings
    }


def sources_of_programs(package: str, near: str, resolver: Resolver) -> Iterator[Source]:
    """The source files of the programs of a package in the workspace of a file."""
    top = resolver.packages.known(near).get(package)
    files = resolver.directories.walk(top) if top else ()
    programs = (path for path in files if path.endswith(_SUFFIXES) and not is_launch(path))
    for path in islice(programs, MAX_FILES):
        source = resolver.readable(path)
        if source and len(source.data) <= MAX_BYTES:
            yield source


def may_publish(package: str, message: str, near: str, resolver: Resolver) -> bool:
    """False if no program of a package in the workspace of a file publishes a type of messages.

    The programs of the packages that it depends on count, too: it may consist of their classes.
    """
    directories = _of_package(package, near, resolver)
    return not directories or _may_name(message, directories, _NOT_PUBLISHED, resolver)


def may_read(package: str, message: str, near: str, resolver: Resolver) -> bool:
    """False if no program of a package, as above, reads a type of messages."""
    directories = _of_package(package, near, resolver)
    return not directories or _may_name(message, directories, _NOT_READ, resolver)


def may_contain(package: str, word: str, near: str, resolver: Resolver) -> bool:
    """False if no program of a package, as above, contains a word."""
    directories = _of_package(package, near, resolver)
    return not directories or _may_name(word, directories, _NOTHING, resolver)


def _of_package(package: str, near: str, resolver: Resolver) -> tuple[str, ...]:
    """The directories of a package in the workspace of a file, and of its dependencies there."""
    known = resolver.packages.known(near)
    if package not in known:
        return ()
    manifest = manifest_of(resolver, os.path.join(known[package], "package.xml"))
    names = {package, *(manifest.dependencies if manifest else ())}
    return tuple(sorted(known[name] for name in names if name in known))


@lru_cache(maxsize=16)  # the messages of one launch file are asked in turn
def _may_name(
    message: str, directories: tuple[str, ...], without: bytes, resolver: Resolver
) -> bool:
    """True if programs below directories name a type of messages; also if not all can be read.

    Args:
        without: a regular expression of parts of a program in Python that do not count.
    """
    files = (path for top in directories for path in resolver.directories.walk(top))
    programs = (path for path in files if path.endswith(_SUFFIXES) and not is_launch(path))
    word = re.escape(message.encode())
    named = re.compile(word + b"|" + _OF_ANY_TYPE)
    prose = re.compile(word + _GOES_ON)
    size = 0
    for path in filter(resolver.admits, programs):
        data = read_head(path, MAX_BYTES)
        size += max(len(data), 1)
        is_long = len(data) >= MAX_BYTES or size > _MOST_OF_PROGRAMS
        if path.endswith(".py"):
            data = prose.sub(b"", re.sub(without, b"", data))
        if is_long or named.search(data):
            return True
    return size == 0


def _files_with_strings(
    words: Iterable[str], prefix: bytes, near: str, resolver: Resolver
) -> Iterator[tuple[str, bytes, set[str]]]:
    """The source files that contain words as strings, their text, and these words."""
    encoded = [word.encode() for word in words]
    quoted = rb"""(["'])""" + prefix + b"(" + b"|".join(map(re.escape, encoded)) + rb""")\1"""
    for path in filter(resolver.admits, islice(_sources(near, resolver), MAX_FILES)):
        data = read_head(path, MAX_BYTES)
        if not any(word in data for word in encoded):
            continue  # most files; the pattern is then not compiled
        if strings := {match[2].decode() for match in re.finditer(quoted, data)}:
            yield path, data, strings


def _sources(near: str, resolver: Resolver) -> Iterator[str]:
    """The source files in the packages that are searched for a file."""
    packages, manifest = resolver.packages, manifest_of(resolver, near)
    if manifest is None:
        return
    package = os.path.dirname(manifest.path)
    parent = os.path.dirname(package)
    tops = [parent if packages.searches(parent, near) else package]
    for name in sorted(manifest.dependencies):
        tops += packages.siblings_named(name, near)
    files = dict.fromkeys(path for top in tops for path in resolver.directories.walk(top))
    directories = tuple(path[: 1 - len(_MANIFEST)] for path in files if path.endswith(_MANIFEST))
    for path in files:
        if path.endswith(_SUFFIXES) and path.startswith(directories):
            yield path
