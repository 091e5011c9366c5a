"""Launch files: the robots that they start, and the files and packages that they need.

XML of ROS 1 and ROS 2, and YAML and Python of ROS 2 are read, as far as constants reach; nothing of
a launch file is run.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from urdfkit.core.static_typing import TYPE_CHECKING
from urdfkit.text.file_kinds import generates_launch, is_parameter_file
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

if TYPE_CHECKING:
    from urdfkit.ros.launch.collect import Collector
    from urdfkit.ros.launch.contents import Launch, LaunchedFile

#: Size of the cache: a check reads a launch file to plan, to check it, and for each robot.
KEPT = 4096


def read_launch(
    source: Source, resolver: Resolver, arguments: Mapping[str, str] | None = None
) -> Launch:
    """Read a launch file, and those that it includes; or a parameter file that nothing loads.

    Args:
        arguments: of the launch file, ``name:=value``.
    """
    return _launch(source, resolver, tuple((arguments or {}).items()))


@lru_cache(KEPT)
def _launch(source: Source, resolver: Resolver, arguments: tuple[tuple[str, str], ...]) -> Launch:
    from urdfkit.ros.launch.collect import Collector  # few robots have a launch file to read
    from urdfkit.ros.launch.contents import LaunchedFile

    collector = Collector(resolver, _read)
    read = _read_parameters if is_parameter_file(source) else _read
    given = dict(arguments)
    read(collector, LaunchedFile(source, given, fixed=frozenset(given)))
    return collector.launch()


def _read_parameters(collector: Collector, file: LaunchedFile) -> None:
    from urdfkit.ros.launch.parameter_file import read

    read(collector, file)


def _read(collector: Collector, file: LaunchedFile) -> None:
    if is_python(file.source):
        from urdfkit.ros.launch.python import read
    else:
        from urdfkit.ros.launch.xml import read
    read(collector, file)


def is_python(source: Source) -> bool:
    """True for a Python program, which ``ros2 launch`` also assumes for unknown suffixes."""
    is_marked = generates_launch(source.data) and not source.data.lstrip().startswith(b"<")
    return source.path.endswith(".py") or is_marked
