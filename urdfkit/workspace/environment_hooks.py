"""Environment hooks of ROS 2 packages, which extend variables when a workspace is sourced.

Source: ``ament_environment_hooks`` of ament_cmake_core, and the format ``dsv`` of colcon-core.
"""

from __future__ import annotations

import os
import posixpath
import re
from collections.abc import Iterator

from urdfkit.core.paths import is_within
from urdfkit.core.record import Record
from urdfkit.text.source import Source, Span
from urdfkit.workspace.cmake import blank_cmake_comments
from urdfkit.workspace.file_head import read_head

SUFFIXES = (".dsv", ".dsv.in")
_CALL = re.compile(rb"(?i)\bament_environment_hooks\s*\(([^()]*)\)")
#: The directory of the CMakeLists.txt, before the path of a hook.
_HERE = re.compile(
    r"^\$\{(?:CMAKE_CURRENT_SOURCE_DIR|CMAKE_CURRENT_LIST_DIR|PROJECT_SOURCE_DIR)\}/"
)
_ENTRY = re.compile(rb"(?m)^[ \t]*(?:ap|pre)pend-non-duplicate[\w-]*;(\w+);([^;\r\n]*)")


class HookEntry(Record):
    """A path that a hook adds to a variable."""

    variable: str
    path: str  # below the directory that the package is installed to: ``share/arm/models``
    span: Span


def hook_entries(package: str, directory: str) -> Iterator[HookEntry]:
    """The entries of the hooks that the CMakeLists.txt of a package names."""
    build = read_head(os.path.join(directory, "CMakeLists.txt"))
    for call in _CALL.finditer(blank_cmake_comments(build)):
        for word in call[1].decode("utf-8", "replace").split():
            name = _HERE.sub("", word.strip('"'))
            if name.endswith(SUFFIXES) and "$" not in name:
                path = os.path.normpath(os.path.join(directory, name))
                if is_within(path, directory):
                    yield from entries(Source(path, read_head(path)), package)


def entries(hook: Source, package: str) -> Iterator[HookEntry]:
    """The entries of a hook."""
    for match in _ENTRY.finditer(hook.data):
        text = match[2].decode("utf-8", "replace").strip().replace("@PROJECT_NAME@", package)
        span = Span(hook, *match.span(2))
        yield HookEntry(match[1].decode(), posixpath.normpath(text), span)
