"""Classes that packages of a workspace export to pluginlib, as far as build files are clear."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.suggest import Suggester, hint_for
from urdfkit.core.words import few
from urdfkit.text.comments import without_comments
from urdfkit.workspace.cmake import cmake_text
from urdfkit.workspace.file_head import is_inside, read_head
from urdfkit.workspace.resolve import Resolver

_COMMAND = "pluginlib_export_plugin_description_file"
#: Classes that a message lists.
_MAX_NAMED = 4
#: The package with the base class, and the file.
_EXPORT = re.compile(rf"(?i)\b{_COMMAND}\s*\(\s*\"?([^\s\")]+)\"?\s+\"?([^\s\")]+)")
#: What a package of ROS 1 exports, in its package.xml.
_EXPORT_OF_ROS_1 = re.compile(rb"\bplugin\s*=\s*[\"']\$\{prefix\}/([^\"']+)")
#: Commands of CMake that may export classes elsewhere.
_UNCLEAR = re.compile(r"(?i)\b(add_subdirectory|include)\s*\(")
_CLASS = re.compile(rb"<class\b([^<>]*)>")
#: pluginlib finds a class by its name, and by its type if it has no name.
_NAME = tuple(re.compile(rb"\b%s\s*=\s*[\"']([^\"']+)" % word) for word in (b"name", b"type"))


def why_unknown(name: str, base: str, near: str, resolver: Resolver) -> tuple[str, str] | None:
    """Why pluginlib does not find a class, and what to write; None if it may find it.

    Args:
        name: of the class, ``PACKAGE/CLASS``.
        base: the package of its base class.
        near: a path in the workspace.
    """
    package = name.partition("/")[0]
    packages = resolver.packages.known(near)
    directory = packages.get(package)
    exported = _exported(directory, package) if directory else None
    if directory is None or exported is None or name in exported:
        return None
    if not exported:
        file = next((path for path, known in _described(directory) if name in known), "")
        message = f"CMakeLists.txt of '{package}' does not export {file}, which describes '{name}'"
        return (message, f"write {_COMMAND}({base} {file})") if file else None
    if any(name in (_exported(other, key) or ()) for key, other in packages.items()):
        return None  # of another package, under this name
    known = [other for other, category in exported.items() if category == base] or list(exported)
    suggested = Suggester(known).suggested(name)
    message = f"package '{package}' exports no class '{name}'{hint_for(suggested)}"
    every = few(known, _MAX_NAMED)
    written = suggested or (f"one of {every}" if len(known) > 1 else every)
    return message, f"write {written}, or add it to the plugin description"


def is_described(name: str, near: str, resolver: Resolver) -> bool:
    """True if a package of the workspace describes a class, which may begin with another package.

    Args:
        name: of the class, ``PACKAGE/CLASS``.
        near: a path in the workspace.
    """
    directories = resolver.packages.known(near).values()
    return any(name in known for one in directories for _, known in _described(one))


def _exported(directory: str, package: str) -> dict[str, str] | None:
    """The classes that a package exports, with the package of their base; None if not clear."""
    text = cmake_text(os.path.join(directory, "CMakeLists.txt"))
    text = text.replace("${PROJECT_NAME}", package)
    if "ament_cmake" not in text or _UNCLEAR.search(text):
        return None
    exported: dict[str, str] = {}
    for base, file in _EXPORT.findall(text):
        data = read_head(os.path.join(directory, file)) if is_inside(file) else b""
        if not data:  # of a build, or with a variable
            return None
        exported.update(dict.fromkeys(_classes(data), base))
    return exported


def _described(directory: str) -> Iterator[tuple[str, list[str]]]:
    """The plugin descriptions of a package, with their classes."""
    names = disk.names_or_empty(directory)
    manifest = read_head(os.path.join(directory, "package.xml")) if "package.xml" in names else b""
    exported = (found.decode("utf-8", "replace") for found in _EXPORT_OF_ROS_1.findall(manifest))
    files = [name for name in names if name.endswith(".xml") and name != "package.xml"]
    for file in dict.fromkeys([*files, *filter(is_inside, exported)]):
        yield file, _classes(read_head(os.path.join(directory, file)))


def _classes(description: bytes) -> list[str]:
    """The names of the classes of a plugin description."""
    found = (
        next(filter(None, (pattern.search(attributes) for pattern in _NAME)), None)
        for attributes in _CLASS.findall(without_comments(description))
    )
    return [match.group(1).decode("utf-8", "replace") for match in found if match]
