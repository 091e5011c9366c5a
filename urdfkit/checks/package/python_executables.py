"""Executables of a Python package that ROS does not find, or that cannot start."""

import ast
import builtins
import os
import posixpath
import re
from fnmatch import fnmatchcase

from urdfkit.checks.package.build_files import is_missing, is_registered, package_file
from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean, hint_for, nearest_file_name
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.launch.python_names import bound_names
from urdfkit.text.python_source import nodes, parse
from urdfkit.text.source import Source, Span
from urdfkit.workspace.executables import EntryPoint, entry_points
from urdfkit.workspace.python_installs import globbed_files, listed_files

#: The directory of executables in a setup.cfg, and where a setup.py may set it itself.
_DIRECTORY = re.compile(rb"(?m)^[ \t]*install[_-]scripts\s*=\s*\$base/lib/([\w.-]+)")
_OPTIONS = re.compile(rb"install[_-]scripts|lib/|\"lib\"|'lib'")
_OF_MODULES = frozenset(("__file__", "__name__", "__doc__"))
_SETUP = "setup"
#: The directory of the file that registers a package, which is reported as such.
_MARKER = "resource/"
#: What is usually meant by a name without an import.
_IMPORTS = {
    "find_packages": "from setuptools import find_packages",
    "glob": "from glob import glob",
    "os": "import os",
}


def not_runnable(name: str, directory: str, *, has_other_name: bool) -> Findings:
    """Executables of a Python package that ROS does not find, or that cannot start.

    Args:
        has_other_name: True if setup.py calls the package by another name, which is reported.
    """
    setup = package_file(directory, "setup.py")
    manifest = package_file(directory, "package.xml")
    if setup is None or manifest is None or b">ament_python<" not in manifest.data:
        return
    text = setup.data.decode("utf-8", "replace")
    try:
        tree = parse(setup.data, setup.path)
    except SyntaxError as error:
        start = setup.offset(error.lineno or 1, error.offset or 1)
        message = f"setup.py is not a Python program: {error.msg}"
        yield Finding(Span(setup, start, start), message, "fix it: colcon cannot build the package")
        return
    yield from _wrong_names(setup, tree)
    yield from _unmatched_patterns(setup, tree, directory)
    yield from _missing_files(setup, tree, directory, "" if has_other_name else name)
    entries = entry_points(text) or []
    config = package_file(directory, "setup.cfg")
    written = config.data if config else b""
    if entries and not _OPTIONS.search(setup.data) and not _DIRECTORY.search(written):
        yield Finding(
            _span_of(setup, entries[0]),
            "setup.cfg does not set install_scripts, so that ROS does not find the executables",
            f"write setup.cfg with [install] install_scripts=$base/lib/{name}, and [develop] "
            f"script_dir=$base/lib/{name}",
        )
    for match in _DIRECTORY.finditer(written) if config and entries else ():
        installed = match.group(1).decode()
        if installed != name and not is_registered(installed, directory) and config is not None:
            message = f"the executables are installed to lib/{installed}"
            yield Finding(Span(config, *match.span(1)), message, f"write {name}")
    if b"package_dir" not in setup.data:
        yield from _missing_packages(setup, entries, directory)
        yield from _missing_modules(setup, entries, directory)


def _missing_packages(setup: Source, entries: list[EntryPoint], directory: str) -> Findings:
    """Directories of modules that do not exist, or that setuptools does not find."""
    match = re.search(
        rb"\bpackages\s*=\s*(?:\[\s*[\"'](\w+)[\"']\s*,?\s*\]|(find_packages)\()", setup.data
    )
    named = match.group(1).decode() if match and match.group(1) else ""
    if match and named and not disk.exists(os.path.join(directory, named)):
        message = f"setup.py names the package '{named}', whose directory does not exist"
        others = {entry.module.partition(".")[0] for entry in entries}
        message += did_you_mean(named, others)
        yield Finding(Span(setup, *match.span(1)), message, "fix the name: the build fails")
    for name in dict.fromkeys(e.module.partition(".")[0] for e in entries):
        path = os.path.join(directory, name)
        initial = os.path.join(path, "__init__.py")
        if match and match.group(2) and disk.is_directory(path) and not disk.exists(initial):
            message = f"find_packages does not find '{name}', which has no __init__.py"
            help = f"create {name}/__init__.py; it may be empty"
            yield Finding(Span(setup, *match.span(2)), message, help, severity=Severity.WARNING)


def _missing_modules(setup: Source, entries: list[EntryPoint], directory: str) -> Findings:
    """Executables whose module or function does not exist."""
    for entry in entries:
        package = entry.module.partition(".")[0]
        if not disk.is_directory(os.path.join(directory, package)):
            continue  # of another package
        path = os.path.join(directory, *entry.module.split("."))
        source = package_file(directory, os.path.relpath(f"{path}.py", directory))
        if source is None and not disk.exists(path) and not disk.exists(f"{path}.py"):
            files = disk.names_or_empty(os.path.dirname(path))
            similar = nearest_file_name(f"{os.path.basename(path)}.py", files)
            message = f"executable '{entry.name}': there is no module {entry.module}"
            message += hint_for(similar and similar.removesuffix(".py"))
            help = "fix the name, or create the module"
            yield Finding(_span_of(setup, entry), message, help, severity=Severity.WARNING)
        elif source and entry.function.rpartition(".")[2].encode() not in source.data:
            message = f"executable '{entry.name}': {entry.module} has no {entry.function}"
            help = "fix the name, or define the function"
            yield Finding(_span_of(setup, entry), message, help, severity=Severity.WARNING)


def _span_of(setup: Source, entry: EntryPoint) -> Span:
    start = setup.offset(entry.line, 1) + entry.column
    return Span(setup, start, start + entry.length)


def _wrong_names(setup: Source, tree: ast.Module) -> Findings:
    """Names that a setup.py does not define, and modules that it calls: colcon stops."""
    bound = list(bound_names(tree))
    if "*" in bound or _SETUP not in bound:
        return  # all names of a module, or none of setuptools
    known = {*bound, *_OF_MODULES, *dir(builtins)}
    modules = {
        alias.name for node in nodes(tree) if isinstance(node, ast.Import) for alias in node.names
    }
    for node in nodes(tree):
        if isinstance(node, ast.Name) and node.id not in known:
            known.add(node.id)  # each name is reported once
            help = f"write {_IMPORTS.get(node.id, 'an import')} above"
            yield Finding(_span(setup, node), f"setup.py: name '{node.id}' is not defined", help)
        called = node.func if isinstance(node, ast.Call) else None
        if isinstance(called, ast.Name) and called.id in modules and bound.count(called.id) == 1:
            modules.remove(called.id)
            help = f"write from {called.id} import {called.id}, or {called.id}.{called.id}(...)"
            message = f"setup.py calls the module '{called.id}'"
            yield Finding(_span(setup, called), message, help)


def _unmatched_patterns(setup: Source, tree: ast.Module, directory: str) -> Findings:
    """Patterns for the directory of the package, whose files are in another one."""
    for target, pattern in globbed_files(tree):
        text = str(pattern.value)
        folder = posixpath.basename(target)
        inside = os.path.join(directory, folder)
        if "/" in text or not disk.is_directory(inside) or _matches(directory, text):
            continue
        if _matches(inside, text):
            yield Finding(
                _span(setup, pattern),
                f"'{text}' matches no file of the package: setup.py installs nothing to {target}",
                f"write {folder}/{text}",
                severity=Severity.WARNING,
            )


def _missing_files(setup: Source, tree: ast.Module, directory: str, package: str) -> Findings:
    """Files that a setup.py installs and that do not exist: colcon stops.

    Args:
        package: its name; empty if the files that register it are not checked.
    """
    listed = list(listed_files(tree))
    installed = {posixpath.normpath(path) for path, _ in listed}
    for path, node in listed:
        is_marker = path.startswith(_MARKER) and package in ("", path.removeprefix(_MARKER))
        if not is_marker and is_missing(directory, path):
            folder, name = posixpath.split(path)
            files = disk.names_or_empty(os.path.join(directory, folder))
            free = {file for file in files if posixpath.join(folder, file) not in installed}
            message = f"'{path}' is installed and does not exist: the build fails"
            help = f"remove it, or create {path}"
            if match := nearest_file_name(name, free):
                help = f"write {posixpath.join(folder, match)}"
            elif path.startswith(_MARKER):
                help = f"write {_MARKER}{package}"
            yield Finding(_span(setup, node), message, help, group_key="not there")


def _matches(directory: str, pattern: str) -> bool:
    return any(fnmatchcase(name, pattern) for name in disk.names_or_empty(directory))


def _span(setup: Source, node: ast.expr) -> Span:
    start = setup.offset(node.lineno, 1) + node.col_offset
    return Span(setup, start, start + (node.end_col_offset or 0) - node.col_offset)
