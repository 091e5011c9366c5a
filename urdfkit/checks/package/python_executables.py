"""Executables of a Python package that ROS does not find, or that cannot start."""

import os
import re

from urdfkit.checks.package.build_files import package_file
from urdfkit.checks.package.setup_programs import missing_files, unmatched_patterns, wrong_names
from urdfkit.core import disk
from urdfkit.core.suggest import did_you_mean
from urdfkit.lint.rules import Finding, Findings, Severity
from urdfkit.text.python_source import parse
from urdfkit.text.source import Source, Span
from urdfkit.workspace.executables import EntryPoint, entry_points

#: The directory of executables in a setup.cfg, and where a setup.py may set it itself.
_DIRECTORY = re.compile(rb"(?m)^\s*install[_-]scripts\s*=\s*\$base/lib/([\w.-]+)")
_OPTIONS = re.compile(rb"install[_-]scripts|lib/|\"lib\"|'lib'")


def not_runnable(name: str, directory: str) -> Findings:
    """Executables of a Python package that ROS does not find, or that cannot start."""
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
    yield from wrong_names(setup, tree)
    yield from unmatched_patterns(setup, tree, directory)
    yield from missing_files(setup, tree, directory)
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
        if match.group(1).decode() != name and config is not None:
            message = f"the executables are installed to lib/{match.group(1).decode()}"
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
        package, _, rest = entry.module.partition(".")
        if not disk.is_directory(os.path.join(directory, package)):
            continue  # of another package
        path = os.path.join(directory, *entry.module.split("."))
        source = package_file(directory, os.path.relpath(f"{path}.py", directory))
        if source is None and not disk.exists(path) and not disk.exists(f"{path}.py"):
            names = [file.removesuffix(".py") for file in disk.names(os.path.dirname(path))]
            message = f"executable '{entry.name}': there is no module {entry.module}"
            message += did_you_mean(rest, names)
            help = "fix the name, or create the module"
            yield Finding(_span_of(setup, entry), message, help, severity=Severity.WARNING)
        elif source and entry.function.encode() not in source.data:
            message = f"executable '{entry.name}': {entry.module} has no {entry.function}"
            help = "fix the name, or define the function"
            yield Finding(_span_of(setup, entry), message, help, severity=Severity.WARNING)


def _span_of(setup: Source, entry: EntryPoint) -> Span:
    start = setup.offset(entry.line, 1) + entry.column
    return Span(setup, start, start + entry.length)
