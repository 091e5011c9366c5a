"""Paths in the home directory of another computer, of files that a package of the workspace has."""

import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.paths import is_within
from urdfkit.errors import PackageNotFound
from urdfkit.lint.rules import Context, Finding, Findings
from urdfkit.text.comments import blank_comments
from urdfkit.text.source import Span
from urdfkit.workspace.manifest import Manifest, manifest_of

#: A path below a home directory. In Python it is a whole string; a path in a longer text may be
#: part of documentation.
_IN_XML = re.compile(rb"(?<![^\s\"'=])/(?:home|Users)/[^\s\"'<>$]+")
_IN_PYTHON = re.compile(rb"(?<=([\"']))/(?:home|Users)/[^\s\"'{}]+(?=\1)")


def paths_of_other_computers(context: Context) -> Findings:
    """Files of packages of the workspace, as paths of the computer on which they were written."""
    for span in _home_paths(context):
        path = span.text
        if disk.exists(path) or not (found := _in_package(context, path)):
            continue
        manifest, rest = found
        package = manifest.package
        message = f"{path} is a path on another computer; package '{package}' has the file"
        if rest.endswith(".py"):
            help = f"install it as an executable of '{package}', and start it as a node"
        elif context.source.path.endswith(".py"):
            help = f"write os.path.join(get_package_share_directory('{package}'), '{rest}')"
        else:
            find = "find-pkg-share" if manifest.ros == 2 else "find"
            help = f"write $({find} {package})/{rest}"
        yield Finding(span, message, help, group_key=package)


def _home_paths(context: Context) -> Iterator[Span]:
    data = context.source.data
    if b"/home/" not in data and b"/Users/" not in data:
        return
    is_python = context.source.path.endswith(".py")
    text = data if is_python else blank_comments(data)
    start = 0
    for line in text.splitlines(keepends=True):
        comment = line.find(b"#") if is_python else -1
        for match in (_IN_PYTHON if is_python else _IN_XML).finditer(line):
            if comment < 0 or match.start() < comment:
                yield Span(context.source, start + match.start(), start + match.end())
        start += len(line)


def _in_package(context: Context, path: str) -> tuple[Manifest, str] | None:
    """The package of the workspace that has a file at the end of a path, and that end.

    The directories of packages have their names.
    """
    near = context.source.path
    workspace = context.resolver.packages.workspace(near)
    parts = path.split("/")
    for i in range(len(parts) - 1, 2, -1):
        try:
            directory = context.resolver.package(parts[i - 1], near)
        except PackageNotFound:
            continue
        file, rest = os.path.join(directory, "package.xml"), "/".join(parts[i:])
        is_own = is_within(directory, workspace) and disk.exists(file)
        manifest = manifest_of(context.resolver, file) if is_own else None
        if manifest and disk.is_file(os.path.join(directory, rest)):
            return manifest, rest
    return None
