"""Names in a setup.py that Python does not know, and files that it does not find."""

import ast
import builtins
import os
import posixpath
from fnmatch import fnmatchcase

from urdfkit.checks.package.build_files import is_missing
from urdfkit.core import disk
from urdfkit.core.suggest import nearest
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.ros.launch.python_names import bound_names
from urdfkit.text.python_source import nodes
from urdfkit.text.source import Source, Span
from urdfkit.workspace.python_installs import globbed_files, listed_files

_OF_MODULES = frozenset(("__file__", "__name__", "__doc__"))
_SETUP = "setup"
#: Where the file is that registers a package, which is reported as such.
_MARKER = "resource/"
#: What is usually meant by a name without an import.
_IMPORTS = {
    "find_packages": "from setuptools import find_packages",
    "glob": "from glob import glob",
    "os": "import os",
}


def wrong_names(setup: Source, tree: ast.Module) -> Findings:
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


def unmatched_patterns(setup: Source, tree: ast.Module, directory: str) -> Findings:
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


def missing_files(setup: Source, tree: ast.Module, directory: str) -> Findings:
    """Files that a setup.py installs and that do not exist: colcon stops."""
    for path, node in listed_files(tree):
        if not path.startswith(_MARKER) and is_missing(directory, path):
            folder = os.path.dirname(path)
            names = [posixpath.join(folder, n) for n in disk.names(os.path.join(directory, folder))]
            message = f"'{path}' is installed and does not exist: the build fails"
            help = f"remove it, or create {path}"
            if match := nearest(path, names):
                help = f"write {match}"
            yield Finding(_span(setup, node), message, help, group_key="not there")


def _matches(directory: str, pattern: str) -> bool:
    return any(fnmatchcase(name, pattern) for name in disk.names(directory))


def _span(setup: Source, node: ast.expr) -> Span:
    start = setup.offset(node.lineno, 1) + node.col_offset
    return Span(setup, start, start + (node.end_col_offset or 0) - node.col_offset)
