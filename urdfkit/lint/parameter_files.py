"""The parameter files of Nav2 and slam_toolbox that no launch file loads."""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from itertools import islice

from urdfkit.core import disk
from urdfkit.lint.config import Config, matches
from urdfkit.text.file_kinds import is_parameter_file
from urdfkit.text.source import Source
from urdfkit.workspace.file_head import MAX_BYTES
from urdfkit.workspace.resolve import Resolver

#: Most YAML files of a directory that are read.
_MAX_FILES = 2_000
_YAML = (".yaml", ".yml")


def unloaded_parameter_files(
    paths: Iterable[str], loaded: set[str], config: Config, resolver: Resolver
) -> Iterator[str]:
    """Those among some files that users name on the command line.

    A file of a package that also has one which a launch file loads is likely an old one.

    Args:
        loaded: real paths of the parameter files that launch files load.
    """
    packages = {_package(path, resolver) for path in loaded}
    for path in islice((path for path in paths if path.endswith(_YAML)), _MAX_FILES):
        is_chosen = resolver.admits(path) and not matches(config.relative(path), config.exclude)
        if is_chosen and _package(path, resolver) not in packages and _is_for_navigation(path):
            yield path


def _package(path: str, resolver: Resolver) -> str:
    package = resolver.packages.enclosing(path)
    return disk.real(package[1] if package else os.path.dirname(path))


def _is_for_navigation(path: str) -> bool:
    source = Source(path, disk.contents(path, MAX_BYTES) or b"")
    if not is_parameter_file(source):
        return False
    from urdfkit.ros.launch.parameter_file import programs_by_node
    from urdfkit.ros.node_parameters import node_parameters

    return any(section.name in programs_by_node() for section in node_parameters(source))
