"""Values for missing xacro arguments of a description, found in other files.

A robot's file may require arguments that a launch file sets. If no launch file sets all of them,
likely values are those that are declared for the same name, names of directories in a path with the
argument: ``config/$(arg ur_type)/limits.yaml``, and those that CMake passes to xacro. Such values
are assumptions.
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
from urdfkit.ros.launch.robot_arguments import declared, passed_arguments
from urdfkit.text.comments import without_comments
from urdfkit.text.diagnostic import Problem
from urdfkit.text.source import Source, shown
from urdfkit.workspace.cmake import cmake_text
from urdfkit.workspace.package_references import FIND
from urdfkit.workspace.resolve import Resolver
from urdfkit.xacro import Xacro

#: Most values of one argument that a message lists.
_FEW = 10

_DECLARATION = re.compile(rb"<xacro:arg\b[^<>]*>")
_ATTRIBUTE = rb"""\s%s\s*=\s*["']([^"'<>]*)["']"""
#: A path in which a directory's name is the value of an argument, or a parameter of that name.
_PATH = r"""["']([^"'<>\n]*/)(?:\$\(arg\s+%s\s*\)|\$\{\s*%s\s*\})(/[^"'<>\n]*)["']"""
_PACKAGE = rf"{FIND}|^package://([\w.-]+)"
#: The variable and items of a loop in a CMakeLists.txt.
_FOREACH = r"foreach\(\s*(\w+)\s([\w\s.-]*)\)"
_EXPRESSION = re.compile(r"\$\{[^{}]*\}|\$\([^()]*\)")


class ArgumentValues(Record):
    """The values that one argument may have."""

    values: tuple[str, ...]  # in the order of the search
    origin: str  # path of the launch file, xacro file or directory of the values


def with_values(problems: Iterable[Problem], xacro: Xacro, resolver: Resolver) -> Iterator[Problem]:
    """The problems of a description, with possible values of missing arguments in their help.

    Args:
        xacro: the expansion of the description.
    """
    for problem in problems:
        name = problem.argument
        found = found_values(name, xacro, resolver) if name else None
        yield problem._replace(help=f"{problem.help}; {reported(found)}") if found else problem


def reported(possible: ArgumentValues) -> str:
    """A message with the origin and values of an argument."""
    verb = "has" if disk.is_directory(possible.origin) else "gives"
    values = [value or "''" for value in possible.values]
    return f"{shown(possible.origin)} {verb} {few(values, _FEW)}"


def found_values(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The possible values of an argument of a description; None if there are none."""
    robot = xacro.sources[0].path
    if sets := passed_arguments(robot, (name,), resolver):
        values = dict.fromkeys(robot.arguments[name] for robot in sets)
        return ArgumentValues(tuple(values), sets[0].launch)
    for launch, choices in declared(robot, resolver):
        if name in choices:
            return ArgumentValues(tuple(choices[name]), launch)
    return (
        _of_includes(name, xacro, resolver)
        or _of_directories(name, xacro, resolver)
        or _of_build(name, robot, resolver)
    )


def combinations(
    names: Collection[str], xacro: Xacro, resolver: Resolver
) -> Iterator[dict[str, tuple[str, str]]]:
    """Sets of values for some arguments, each value with its origin.

    One argument at a time takes each of its values, while the others have their first one. Empty
    if an argument has no possible value.
    """
    possible: dict[str, ArgumentValues] = {}
    for name in names:
        values = found_values(name, xacro, resolver)
        if values is None:
            return
        possible[name] = values
    first = {name: (values.values[0], values.origin) for name, values in possible.items()}
    yield first
    for name, (choices, origin) in possible.items():
        for value in choices[1:]:
            yield first | {name: (value, origin)}


def _of_includes(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The default in a file that is included after the use of the argument, or not reached."""
    for source in xacro.sources:
        for file in re.findall(INCLUDE, without_comments(source.data)):
            path = plain_path(file.decode("utf-8", "replace"), source, resolver)
            if not path or not resolver.allows(path, source.path):
                continue
            default = _default(name, path, resolver)
            if default is not None:
                return ArgumentValues((default,), path)
    return None


def _default(name: str, path: str, resolver: Resolver) -> str | None:
    """The default of an argument in a file, without expressions; None if there is none."""
    source = resolver.readable(path)
    for tag in _DECLARATION.findall(without_comments(source.data)) if source else ():
        attributes = _attributes(tag, b"name", b"default")
        if attributes.get(b"name") == name and "$" not in attributes.get(b"default", "$"):
            return attributes[b"default"]
    return None


def _attributes(tag: bytes, *names: bytes) -> Mapping[bytes, str]:
    matches = {name: re.search(_ATTRIBUTE % name, tag) for name in names}
    return {
        name: match.group(1).decode("utf-8", "replace") for name, match in matches.items() if match
    }


def _of_directories(name: str, xacro: Xacro, resolver: Resolver) -> ArgumentValues | None:
    """The names of the directories with which all paths with the argument exist."""
    word = re.escape(name)
    common: set[str] | None = None
    origin = ""
    for source in xacro.sources:
        text = without_comments(source.data).decode("utf-8", "replace")
        for head, rest in dict.fromkeys(re.findall(_PATH % (word, word), text)):
            directory = plain_path(head, source, resolver)
            if not directory or not resolver.allows(directory, source.path):
                continue
            existing = set(_containing(rest, name, directory, resolver))
            if common is None:
                common, origin = existing, directory
            else:
                common &= existing
    return ArgumentValues(tuple(sorted(common)), origin) if common else None


def _of_build(name: str, robot: str, resolver: Resolver) -> ArgumentValues | None:
    """The values that CMake passes to xacro for a robot, with those of a ``foreach``."""
    package = resolver.packages.enclosing(robot)
    path = os.path.join(package[1], "CMakeLists.txt") if package else ""
    text = cmake_text(path) if path else ""
    if os.path.basename(robot) not in text:
        return None
    loops: dict[str, list[str]] = {}
    for variable, items in re.findall(_FOREACH, text):
        words = items.split()
        loops.setdefault(f"${{{variable}}}", words[2:] if words[:2] == ["IN", "ITEMS"] else words)
    passed = re.findall(rf"(?<!\w){re.escape(name)}:=([^\s\"'()<>]+)", text)
    values = dict.fromkeys(item for value in passed for item in loops.get(value, [value]))
    plain = tuple(value for value in values if "$" not in value)
    return ArgumentValues(plain, path) if plain else None


def plain_path(text: str, source: Source, resolver: Resolver) -> str:
    """The absolute path for a path in a file; empty if it contains other expressions."""
    here = os.path.dirname(os.path.abspath(source.path))

    def package(match: re.Match[str]) -> str:
        try:
            return resolver.package(match.group(1) or match.group(2), source.path)
        except PackageNotFound:
            return "$"

    text = re.sub(_PACKAGE, package, text.removeprefix("file://")).replace("$(dirname)", here)
    return "" if "$" in text else os.path.normpath(os.path.join(here, text))


def _containing(rest: str, name: str, directory: str, resolver: Resolver) -> Iterator[str]:
    """The subdirectories of a directory in which the rest of a path exists."""
    itself = re.compile(rf"\$\(arg\s+{re.escape(name)}\s*\)|\$\{{\s*{re.escape(name)}\s*\}}")
    for entry, is_directory in (resolver.directories.entries(directory) or {}).items():
        if is_directory and re.fullmatch(r"\w[\w.-]*", entry):
            plain = map(glob.escape, _EXPRESSION.split(itself.sub(entry, rest)))
            pattern = glob.escape(os.path.join(directory, entry)) + "*".join(plain)
            if any(True for _ in glob.iglob(pattern)):
                yield entry
