"""Executables of a package of ROS 2, as far as its build file names them literally."""

from __future__ import annotations

import ast
import os
import posixpath
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.record import Record
from urdfkit.text import python_source
from urdfkit.workspace.cmake import cmake_text
from urdfkit.workspace.file_head import head_text, is_inside
from urdfkit.workspace.install_rules import build_file

#: Commands of CMake that may make or install executables under names that are not written there.
#: Modules of CMake itself make none, nor do the files that packages such as Qt ask to include.
_UNCLEAR = re.compile(
    r"(?i)\b(?:add_subdirectory|foreach|function|macro|ExternalProject\w*|execute_process)\s*\("
    r"|\binclude\s*\((?!\s*(?:FetchContent|GNUInstallDirs|CTest|Check\w+|\$\{\w+_USE_FILE\})\s*\))"
    r"|\b(?:SETUP_CFG|PACKAGE_DIR)\b|\badd_executable\s*\(\s*\"?\$"
    r"|install\s*\(\s*(?:DIRECTORY[^()]*\bDESTINATION\s+\S*\blib\b|PROGRAMS\b[^()$]*\$)"
)
_EXECUTABLE = r"(?i)\badd_executable\s*\(\s*([\w.-]+)"
_PROGRAM = r"(?i)\binstall\s*\(\s*PROGRAMS\b([^()]*?)\bDESTINATION\b"
_TARGETS = r"(?i)\binstall\s*\(\s*TARGETS\b([^()]*)\)"
_INSTALL = r"(?i)\binstall\s*\(\s*(?:PROGRAMS|TARGETS)\b([^()]*)\)"
_COMPONENT = r"(?i)\bEXECUTABLE\s+\"?([\w.-]+)"


class EntryPoint(Record):
    """An executable of a setup.py."""

    name: str
    module: str  # with dots
    function: str
    line: int
    column: int  # of the text of the entry, in bytes
    length: int


#: Files of C++, whose names are not those of executables.
_SOURCE_FILE = re.compile(r"(?<![^\s\"();])[^\s\"();]+\.(?:c|cc|cpp|cxx|h|hpp)(?![\w.])")


class MissingExecutable(Record):
    """An executable that the build of a package does not install."""

    is_built: bool  # True if it is built all the same
    others: tuple[str, ...]  # the executables that it has
    place: str = ""  # where it is installed instead of lib/PACKAGE; empty if nowhere


def missing_executable(directory: str, package: str, name: str) -> MissingExecutable | None:
    """Why a package does not have an executable; None if it has, or may have it."""
    file = build_file(directory)
    if file.endswith(".py"):
        return _of_python(head_text(file), name)
    text = cmake_text(file) if file else ""
    # ament_python_install_package installs the console scripts of this file.
    places = (os.path.join(directory, "setup.cfg"), os.path.join(directory, package, "setup.cfg"))
    is_unclear = "ament_python_install_package" in text and any(map(disk.exists, places))
    if not file or is_unclear:
        return None
    return _of_cmake(text, package, name)


def _of_cmake(text: str, package: str, name: str) -> MissingExecutable | None:
    text = text.replace("${PROJECT_NAME}", package)
    if _UNCLEAR.search(text):
        return None
    built = re.findall(_EXECUTABLE, text)
    scripts = [path for group in re.findall(_PROGRAM, text) for path in group.split()]
    others = [*built, *map(os.path.basename, scripts), *re.findall(_COMPONENT, text)]
    if place := _misplaced(text, package, name):
        return MissingExecutable(True, tuple(others), place)
    if name in built and "ament_auto_package" not in text:
        installed = " ".join(re.findall(_TARGETS, text))
        is_installed = "${" in installed or name in re.split(r"[\s\"]+", installed)
        return None if is_installed else MissingExecutable(True, tuple(others))
    stem = re.escape(name.removesuffix(".py"))
    end = "" if name.endswith(".py") else r"(?!\.py\b)"  # a script keeps its suffix
    rest = _SOURCE_FILE.sub(" ", text.replace(package, " ", 1))
    is_named = re.search(rf"(?<![\w-]){stem}(?![\w-]){end}", rest)
    return (
        None
        if is_named or ("${" in text and not others)
        else MissingExecutable(False, tuple(others))
    )


def script_of(directory: str, package: str, name: str) -> str:
    """The path of a Python script that a build installs as an executable; empty if unknown."""
    text = cmake_text(build_file(directory)).replace("${PROJECT_NAME}", package)
    for group in re.findall(_PROGRAM, text) if name.endswith(".py") else ():
        for path in group.split():
            if os.path.basename(path) == name and "$" not in path and is_inside(path):
                return os.path.join(directory, path)
    return ""


def program_of(directory: str, package: str, name: str) -> str:
    """The path of the Python program that a build installs as an executable; empty if unknown."""
    setup = os.path.join(directory, "setup.py")
    text = head_text(setup) if disk.is_file(setup) else ""
    entries = (entry_points(text) or []) if text else []
    for entry in entries:
        path = os.path.join(*entry.module.split(".")) + ".py"
        if entry.name == name and is_inside(path):
            return os.path.join(directory, path)
    return script_of(directory, package, name)


def _misplaced(text: str, package: str, name: str) -> str:
    """Where a build installs an executable that ROS looks for in ``lib/PACKAGE``; empty if unknown.

    ``install`` has a destination for each kind of target; that of executables is RUNTIME.
    """
    places: set[str] = set()
    for arguments in re.findall(_INSTALL, text):
        words = [word.strip('"') for word in arguments.split()]
        end = next((i for i, word in enumerate(words) if word.isupper()), len(words))
        if name not in map(os.path.basename, words[:end]):
            continue
        kinds = [i for i in range(end, len(words) - 1) if words[i] == "DESTINATION"]
        runtime = [i for i in kinds if words[i - 1] == "RUNTIME"] or kinds
        places.update(posixpath.normpath(words[i + 1]) for i in runtime)
    is_known = places and "$" not in "".join(places) and f"lib/{package}" not in places
    return ", ".join(sorted(places)) if is_known else ""


def _of_python(text: str, name: str) -> MissingExecutable | None:
    entries = entry_points(text)
    if entries is None or re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", text):
        return None
    if any(map(_installs_executables, ast.walk(python_source.parse(text)))):
        return None
    return MissingExecutable(False, tuple(entry.name for entry in entries))


def _installs_executables(node: ast.AST) -> bool:
    """True for a pair of data_files that copies files with computed names to ``lib/PACKAGE``."""
    if not isinstance(node, ast.Tuple) or len(node.elts) != 2:
        return False
    place, files = node.elts
    texts = [part.value for part in ast.walk(place) if isinstance(part, ast.Constant)]
    is_lib = any(isinstance(text, str) and text.partition("/")[0] == "lib" for text in texts)
    return is_lib and not isinstance(files, (ast.List, ast.Tuple))


def entry_points(text: str) -> list[EntryPoint] | None:
    """The console scripts of a setup.py; None if some are not literals, or in another way."""
    try:
        tree = python_source.parse(text)
    except SyntaxError:
        return None
    calls = [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    setups = [call for call in calls if getattr(call.func, "id", "") == "setup"]
    keywords = {keyword.arg: keyword.value for call in setups for keyword in call.keywords}
    if len(setups) != 1 or None in keywords or not {"scripts", "cmdclass"}.isdisjoint(keywords):
        return None
    groups = keywords.get("entry_points", ast.Dict([], []))
    if not isinstance(groups, ast.Dict):
        return None
    named = zip(map(python_source.string, groups.keys), groups.values, strict=True)
    lists = [value for key, value in named if key in ("console_scripts", None)]
    entries = [entry for value in lists for entry in _entries(value)]
    known = [entry for entry in entries if entry is not None]
    return known if len(known) == len(entries) else None


def _entries(node: ast.expr) -> Iterator[EntryPoint | None]:
    for item in node.elts if isinstance(node, (ast.List, ast.Tuple)) else (node,):
        text = python_source.string(item) or ""
        match = re.fullmatch(r"\s*([\w.-]+)\s*=\s*([\w.]+)\s*:\s*([\w.]+)\s*", text)
        if match is None:
            yield None
        else:
            name, module, function = match.groups()
            length = len(text.encode()) + 2  # with quotation marks
            yield EntryPoint(name, module, function, item.lineno, item.col_offset, length)
