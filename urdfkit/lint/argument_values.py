"""Values for the xacro arguments that a description lacks, from the files around it.

A robot's file may want arguments that a launch file gives. Where no launch file gives all of them,
a value is likely that is declared for the same name, or that names a directory which a path with
the argument leads to: ``config/$(arg ur_type)/limits.yaml``. Such values are tried, not believed.
"""

from __future__ import annotations

import glob
import os
import re
from collections.abc import Collection, Iterable, Iterator, Mapping

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.core.words import few
from urdfkit.errors import PackageNotFound
from urdfkit.lint.include_graph import INCLUDE
from urdfkit.ros.launch.robot_arguments import declared, given
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Source, shown
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro

#: Values of one argument that a message names.
_FEW = 10

_DECLARATION = re.compile(rb"<xacro:arg\b[^<>]*>")
_ATTRIBUTE = rb"""\s%s\s*=\s*["']([^"'<>]*)["']"""
#: A path in which a whole directory is the value of an argument, or of a parameter called like it.
_PATH = r"""["']([^"'<>\n]*/)(?:\$\(arg\s+%s\s*\)|\$\{\s*%s\s*\})(/[^"'<>\n]*)["']"""
_PACKAGE = rf"{FIND}|^package://([\w.-]+)"
_EXPRESSION = re.compile(r"\$\{[^{}]*\}|\$\([^()]*\)")


class ArgumentValues(Record):
    """The values that one argument may have."""

    values: tuple[str, ...]  # in the order in which they are found
    origin: str  # path of the launch file, xacro file or directory that they are from


def with_values(problems: Iterable[Problem], xacro: Xacro, resolver: Resolver) -> Iterator[Problem]:
    """The problems of a description, with the values that are found for arguments without one.

    Args:
        xacro: its expansion.
    """
    for problem in problems:
        name = problem.argument
        found = found_values(name, xacro, resolver) if name else None
        yield problem._replace(help=f"{problem.help}; {reported(found)}") if found else problem


def reported(found: ArgumentValues) -> str:
    """The values of an argument, and where they are from."""
    verb = "has" if disk.is_directory(found.origin) else "gives"
    values = [value or "''" for value in found.values]
    return f"{shown(found.origin)} {verb} {few(values, _FEW)}"


def found_values(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The values that one argument of a description may have; None if there are none."""
    robot = xacro.sources[0].path
    if sets := given(robot, (name,), resolver):
        return ArgumentValues(
            tuple(dict.fromkeys(one.arguments[name] for one in sets)), sets[0].launch
        )
    for launch, choices in declared(robot, resolver):
        if name in choices:
            return ArgumentValues(tuple(choices[name]), launch)
    return _of_includes(name, xacro, resolver) or _of_directories(name, xacro, resolver)


def combinations(
    names: Collection[str], xacro: Xacro, resolver: Resolver
) -> Iterator[dict[str, tuple[str, str]]]:
    """Sets of values for some arguments, each value with where it is from.

    One argument takes each of its values, and the others then their first one. There are none
    unless each of them has a value.
    """
    found: dict[str, ArgumentValues] = {}
    for name in names:
        values = found_values(name, xacro, resolver)
        if values is None:
            return
        found[name] = values
    first = {name: (one.values[0], one.origin) for name, one in found.items()}
    varied = (
        {name: (value, one.origin)} for name, one in found.items() for value in one.values[1:]
    )
    yield first
    for change in varied:
        yield first | change


def _of_includes(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The default in a file that is included below the use of the argument, or was not reached."""
    for source in xacro.sources:
        for file in INCLUDE.findall(without_comments(source.data)):
            path = plain_path(file.decode("utf-8", "replace"), source, resolver)
            if not path or not resolver.allows(path, source.path):
                continue
            default = _default(name, path, resolver)
            if default is not None:
                return ArgumentValues((default,), path)
    return None


def _default(name: str, path: str, resolver: Resolver) -> str | None:
    """The default of an argument that a file declares; None if there is none."""
    source = resolver.readable(path)
    for tag in _DECLARATION.findall(without_comments(source.data)) if source else ():
        words = _attributes(tag, b"name", b"default")
        if words.get(b"name") == name and "$" not in words.get(b"default", "$"):
            return words[b"default"]
    return None


def _attributes(tag: bytes, *names: bytes) -> Mapping[bytes, str]:
    found = {name: re.search(_ATTRIBUTE % name, tag) for name in names}
    return {name: at.group(1).decode("utf-8", "replace") for name, at in found.items() if at}


def _of_directories(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The names of the directories to which all paths with the argument lead."""
    word = re.escape(name)
    common: set[str] | None = None
    origin = ""
    for source in xacro.sources:
        text = without_comments(source.data).decode("utf-8", "replace")
        for head, rest in dict.fromkeys(re.findall(_PATH % (word, word), text)):
            directory = plain_path(head, source, resolver)
            if not directory or not resolver.allows(directory, source.path):
                continue
            there = set(_leading_to(rest, name, directory, resolver))
            common, origin = (there, directory) if common is None else (common & there, origin)
    return ArgumentValues(tuple(sorted(common)), origin) if common else None


def plain_path(text: str, source: Source, resolver: Resolver) -> str:
    """A path in a file, absolute; empty if only the expansion can compute it."""
    here = os.path.dirname(os.path.abspath(source.path))

    def package(match: re.Match[str]) -> str:
        try:
            return resolver.package(match.group(1) or match.group(2), source.path)
        except PackageNotFound:
            return "$"

    text = re.sub(_PACKAGE, package, text.removeprefix("file://")).replace("$(dirname)", here)
    return "" if "$" in text else os.path.normpath(os.path.join(here, text))


def _leading_to(rest: str, name: str, directory: str, resolver: Resolver) -> Iterator[str]:
    """The directories below one in which the rest of a path is there."""
    itself = re.compile(rf"\$\(arg\s+{re.escape(name)}\s*\)|\$\{{\s*{re.escape(name)}\s*\}}")
    for entry, is_directory in (resolver.directories.entries(directory) or {}).items():
        if is_directory and re.fullmatch(r"\w[\w.-]*", entry):
            plain = map(glob.escape, _EXPRESSION.split(itself.sub(entry, rest)))
            pattern = glob.escape(os.path.join(directory, entry)) + "*".join(plain)
            if any(True for _ in glob.iglob(pattern)):
                yield entry
