"""The package.xml of a file's package: its name, build system and dependencies."""

from __future__ import annotations

import os
import re

from urdfkit.core import disk
from urdfkit.core.paths import upwards
from urdfkit.core.record import Record
from urdfkit.errors import PackageNotFound
from urdfkit.text.comments import without_comments
from urdfkit.text.source import Source
from urdfkit.workspace.file_head import MAX_BYTES, read_head
from urdfkit.workspace.package_directories import dependencies
from urdfkit.workspace.package_references import package_references
from urdfkit.workspace.resolve import Resolver
from urdfkit.workspace.ros_packages import comes_with_ros
from urdfkit.workspace.submodules import absent_submodules

#: Directories of a package that are searched for descriptions.
MAX_DIRECTORIES = 200

_FORMAT = rb"""<package\b[^<>]*\bformat\s*=\s*["'](\d+)["']"""
_BUILD = rb"<(?:buildtool_depend|build_type)\b[^<>]*>\s*(ament|catkin)"

#: Tags that every package.xml has.
REQUIRED = ("name", "version", "description", "maintainer", "license")
#: Other tags of all formats, and tags of single formats.
_OPTIONAL = frozenset(
    "author build_depend buildtool_depend conflict export replace test_depend url".split()
)
_SINCE_2 = frozenset(
    "build_export_depend buildtool_export_depend depend doc_depend exec_depend".split()
)
_BY_FORMAT = {
    "1": frozenset(("run_depend",)),
    "2": _SINCE_2,
    "3": _SINCE_2 | {"group_depend", "member_of_group"},
}


class Manifest(Record):
    """A package.xml."""

    path: str
    package: str  # name of the package
    data: bytes  # the text without comments

    @property
    def dependencies(self) -> frozenset[str]:
        """Names of the packages in dependencies of all kinds."""
        return dependencies(self.data)

    @property
    def dependency_tag(self) -> str:
        """The tag for a dependency at run time, which depends on the format."""
        number = re.search(_FORMAT, self.data)
        return "exec_depend" if number and number.group(1) in (b"2", b"3") else "run_depend"

    @property
    def ros(self) -> int | None:
        """ROS version 1 or 2 by the build system; None if none or both are declared."""
        systems = set(re.findall(_BUILD, self.data))
        return {b"catkin": 1, b"ament": 2}[systems.pop()] if len(systems) == 1 else None


def manifest_of(resolver: Resolver, path: str) -> Manifest | None:
    """The package.xml of the package that contains a file; None outside of packages."""
    enclosing = resolver.packages.enclosing(path)
    if enclosing is None:
        return None
    name, directory = enclosing
    file = os.path.join(directory, "package.xml")
    data = resolver.text(file)
    if data is None:
        data = disk.contents(file, MAX_BYTES)
    # A rosbuild package has none.
    return None if data is None else Manifest(file, name, without_comments(data))


def is_known_dependency(name: str, path: str, resolver: Resolver) -> bool:
    """True if the name of a missing package is probably right.

    The package comes with ROS, the package of the file declares it, or the repository has a
    submodule that is not checked out and may contain it.
    """
    manifest = manifest_of(resolver, path)
    return (
        comes_with_ros(name)
        or (manifest is not None and name in manifest.dependencies)
        or bool(absent_submodules(resolver.packages.root(path).directory))
    )


def depends_on(name: str, other: str, near: str, resolver: Resolver) -> bool:
    """True if a package depends on another, also indirectly: the reverse would make a cycle.

    References in its descriptions count as well as declared dependencies.

    Args:
        other: name of the possible dependency.
        near: path of a file from which packages are searched.
    """
    visited = {name}
    queue = [name]
    for package in queue:  # grows during the iteration
        dependencies = _dependencies_of(package, near, resolver)
        if other in dependencies:
            return True
        queue += sorted(dependencies - visited)
        visited |= dependencies
    return False


def _dependencies_of(name: str, near: str, resolver: Resolver) -> frozenset[str]:
    """The packages that a package declares or uses; empty if it is installed or missing."""
    try:
        directory = resolver.package(name, near)
    except PackageNotFound:
        return frozenset()
    manifest = manifest_of(resolver, os.path.join(directory, "package.xml"))
    if manifest is None or not resolver.packages.searches(directory, near):
        return frozenset()
    if manifest.package != name and comes_with_ros(name):
        return frozenset()  # a directory such as xacro/ or urdf/ of another package
    files = resolver.directories.files_below(directory, MAX_DIRECTORIES)
    texts = [Source(path, read_head(path)) for path in files if path.endswith((".urdf", ".xacro"))]
    used = {reference.package for text in texts for reference in package_references(text)}
    return manifest.dependencies.union(used) - {name}


def known_tags(number: str | None) -> frozenset[str]:
    """The tags of a format, by default 1; empty for an unknown format."""
    own = _BY_FORMAT.get(number or "1")
    return own.union(REQUIRED, _OPTIONAL) if own else frozenset()


def nearest_manifest(path: str) -> str | None:
    """Path of the nearest package.xml above a file, which may be invalid; None if there is none."""
    directories = upwards(os.path.dirname(os.path.abspath(path)))
    files = (os.path.join(directory, "package.xml") for directory in directories)
    return next(filter(disk.is_file, files), None)
