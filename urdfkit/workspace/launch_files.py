"""The launch files that may start a robot."""

import os
from collections.abc import Iterator
from itertools import islice

from urdfkit.text.file_kinds import generates_launch, has_launch_name, is_launch
from urdfkit.text.source import Source, shown
from urdfkit.workspace.resolve import Resolver

#: Launch files of a directory that are read, and directories that are searched for them.
MAX_FILES, MAX_DIRECTORIES = 200, 2000
_MODULE = f"{os.sep}__init__.py"


def launch_files(directory: str, mentioned: str, resolver: Resolver) -> Iterator[Source]:
    """The launch files of a directory whose text mentions a package."""
    paths = list(resolver.directories.files_below(directory, MAX_DIRECTORIES))
    # A package of Python may be called launch, too.
    modules = {os.path.dirname(path) for path in paths if path.endswith(_MODULE)}
    files = (
        path
        for path in paths
        if has_launch_name(path) or (is_launch(path) and os.path.dirname(path) not in modules)
    )
    for path in islice(files, MAX_FILES):
        source = resolver.readable(shown(path))
        if source is None or mentioned.encode() not in source.data:
            continue
        if has_launch_name(path) or generates_launch(source.data):
            yield source


def directories_of_launch_files(robot: str, resolver: Resolver) -> Iterator[tuple[str, str]]:
    """Directories whose launch files may start a robot, and the package that they then mention."""
    if package := resolver.packages.enclosing(robot):
        yield package[1], ""
        workspace = resolver.packages.workspace(robot)
        if workspace != package[1]:
            yield workspace, package[0]


def has_launch_files(robot: str, resolver: Resolver) -> bool:
    """True if some launch file may start a robot."""
    directories = directories_of_launch_files(robot, resolver)
    return any(any(launch_files(*place, resolver)) for place in directories)
