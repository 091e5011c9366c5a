"""The packages whose build is checked, and their files."""

import os
import re
from collections.abc import Iterator

from urdfkit.core import disk
from urdfkit.core.paths import upwards
from urdfkit.lint.rules import Context, Finding, Findings, Severity
from urdfkit.text.file_kinds import is_launch
from urdfkit.text.source import Source, Span
from urdfkit.workspace.file_head import read_head
from urdfkit.workspace.install_rules import build_file
from urdfkit.workspace.manifest import manifest_of
from urdfkit.workspace.package_directories import IGNORE_FILES
from urdfkit.workspace.package_references import have_references
from urdfkit.workspace.ros_packages import comes_with_ros

#: The call that generates messages, services and actions.
INTERFACES = rb"\brosidl_generate_interfaces\s*\(\s*[^\s()]+\s([^()]*)\)"
#: Where each build file gives the name, as far as it is written out.
_NAMES = {
    # No part of a name, such as that in front of a variable.
    "CMakeLists.txt": rb"(?im)^[^#\n]*?\bproject\s*\(\s*\"?([A-Za-z][\w-]*)(?![\w$-])",
    "setup.py": rb"(?m)^[ \t]*(?:package_name|PACKAGE_NAME)\s*=\s*[\"']([\w-]+)[\"']",
}


def refers_to_packages(context: Context) -> bool:
    """True for a launch file, and for a description that refers to packages."""
    return is_launch(context.source.path) or have_references(context.document.sources)


def packages_to_build(context: Context) -> dict[str, str]:
    """The package of a file, and those of the programs that it starts, with their directories."""
    if not refers_to_packages(context):
        return {}
    home = context.resolver.packages.enclosing(context.source.path)
    packages = (dict([home]) if home else {}) | _started(context)
    return {name: path for name, path in packages.items() if not _is_ignored(path)}


def _started(context: Context) -> dict[str, str]:
    """The packages of this workspace whose programs a launch file starts, with directories."""
    started = context.launch.started if is_launch(context.source.path) else ()
    names = sorted({node.package for node in started if not comes_with_ros(node.package)})
    known = context.resolver.packages.known(context.source.path) if names else {}
    return {name: known[name] for name in names if known.get(name)}


def packages_with_interfaces(context: Context) -> Iterator[str]:
    """The directories of those on which the package of a file depends, in its workspace."""
    home = context.resolver.packages.enclosing(context.source.path)
    if not home or not refers_to_packages(context) or _is_ignored(home[1]):
        return
    manifest = manifest_of(context.resolver, context.source.path)
    names = sorted(manifest.dependencies) if manifest and manifest.ros == 2 else ()
    names = [name for name in names if not comes_with_ros(name)]
    known = context.resolver.packages.known(context.source.path) if names else {}
    for directory in filter(None, map(known.get, names)):
        build = package_file(directory, "CMakeLists.txt")
        if build and re.search(INTERFACES, build.data) and not _is_ignored(directory):
            yield directory


def _is_ignored(directory: str) -> bool:
    """True for a package that the build skips, as a file in its directory or above it says."""
    for above in upwards(directory):
        if any(disk.exists(os.path.join(above, mark)) for mark in IGNORE_FILES):
            return True
        if disk.exists(os.path.join(above, ".git")):
            break
    return False


def other_name(name: str, directory: str) -> Findings:
    """A build file whose project has another name than the package."""
    file = os.path.basename(build_file(directory))
    source = package_file(directory, file) if file else None
    if source is None:
        return
    every = _names(source)
    if every and name not in [match.group(1).decode() for match in every]:
        project = every[0]
        yield Finding(
            Span(source, *project.span(1)),
            f"project name '{project.group(1).decode()}' in {file} differs from the package name "
            f"'{name}' in package.xml",
            "use the same name in both files",
            severity=Severity.WARNING,
        )


def _names(source: Source) -> list[re.Match[bytes]]:
    """The names in a build file; of several projects, as in a superbuild, one is the package."""
    return list(re.finditer(_NAMES[os.path.basename(source.path)], source.data))


def is_registered(name: str, directory: str) -> bool:
    """True if a setup.py registers the package under a name, that of package.xml or another."""
    setup = package_file(directory, "setup.py")
    if setup is None or b"resource_index" not in setup.data:
        return False
    return any(match.group(1).decode() == name for match in _names(setup))


def package_file(directory: str, file: str) -> Source | None:
    """A file of a package; None if it is missing, or not a regular file."""
    path = os.path.join(directory, file)
    data = read_head(path)
    return Source(path, data) if data else None


def is_missing(directory: str, path: str) -> bool:
    """True if a file of a package does not exist, and is not one that the build creates."""
    whole = os.path.normpath(os.path.join(directory, path))
    if not whole.startswith(os.path.join(directory, "")) or disk.exists(whole):
        return False
    from urdfkit.workspace.gitignore import is_ignored  # which runs git

    return not is_ignored(whole)
