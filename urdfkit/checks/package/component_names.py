"""Components that CMakeLists.txt names otherwise than the sources of the package.

Source: ``rclcpp_components_register_nodes.cmake`` and ``component_manager.cpp`` of ros2/rclcpp,
which compares the text of the class as it stands in the macro.
"""

import re

from urdfkit.checks.package.build_files import package_file
from urdfkit.core.suggest import TYPO, nearest
from urdfkit.lint.rules import Finding, Findings
from urdfkit.text.source import Span
from urdfkit.workspace.cmake import blank_cmake_comments
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.resolve import Resolver

_CALL = rb"\brclcpp_components_register_nodes?\s*\(([^()]*)\)"
#: A class that is written out, without a variable of CMake.
_CLASS = rb"(?<![\w${}:])[A-Za-z_]\w*(?:::\w+)+(?![\w${}:])"
_MACRO = rb"RCLCPP_COMPONENTS_REGISTER_NODE"
_REGISTERED = rb"\b" + _MACRO + rb"\s*\(\s*([\w:]+)\s*\)"
_COMMENTS = rb"(?s)//[^\n]*|/\*.*?(?:\*/|\Z)"
_MAX_BYTES = 1_000_000  # of a source
_SUFFIXES = (".cpp", ".cc", ".cxx", ".hpp", ".h")


def unregistered_components(directory: str, resolver: Resolver) -> Findings:
    """Classes of CMakeLists.txt that no source registers, so that no container loads them."""
    build = package_file(directory, "CMakeLists.txt")
    if build is None or b"rclcpp_components" not in build.data:
        return
    calls = list(re.finditer(_CALL, blank_cmake_comments(build.data)))
    registered = _registered(directory, resolver) if calls else set()
    for call in calls:
        for match in re.finditer(_CLASS, call[1]) if registered else ():
            name = match[0].decode()
            others = [other for other in registered if _last(other) == _last(name)]
            meant = others[0] if others else nearest(name, registered, TYPO)
            if name not in registered and meant:
                start = call.start(1) + match.start()
                yield Finding(
                    Span(build, start, start + len(match[0])),
                    f"no source registers component '{name}'; did you mean '{meant}'?",
                    f"write {meant} here, or the same class in {_MACRO.decode()}",
                )


def _last(name: str) -> str:
    return name.rpartition("::")[2]


def _registered(directory: str, resolver: Resolver) -> set[str]:
    """The classes that the sources of a package register; empty if some are not clear."""
    names: set[str] = set()
    paths = (path for path in resolver.directories.walk(directory) if path.endswith(_SUFFIXES))
    for path in filter(resolver.admits, paths):
        data = read_head(path, _MAX_BYTES)
        if len(data) == _MAX_BYTES or (_MACRO in data and _defines_macro(data)):
            return set()
        names |= {name.decode() for name in re.findall(_REGISTERED, re.sub(_COMMENTS, b" ", data))}
    return names


def _defines_macro(source: bytes) -> bool:
    """True if another macro registers components."""
    before = b""
    for line in source.splitlines():
        if _MACRO in line and (line.lstrip().startswith(b"#") or before.endswith(b"\\")):
            return True
        before = line.rstrip()
    return False
