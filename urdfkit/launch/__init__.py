"""Launch files: which robot they describe, and which files and packages they need.

XML of ROS 1 and ROS 2 and the Python of ROS 2 are read, as far as constants reach; nothing of a
launch file is run.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from urdfkit.launch.found import Launch
    from urdfkit.source import Source
    from urdfkit.workspace.resolve import Resolver


def read_launch(
    source: Source, resolver: Resolver, arguments: Mapping[str, str] | None = None
) -> Launch:
    """Read a launch file.

    Args:
        source: the file.
        resolver: finds packages.
        arguments: of the launch file, ``name:=value``.
    """
    if source.path.endswith(".py"):
        from urdfkit.launch.python import read
    else:
        from urdfkit.launch.xml import read
    return read(source, resolver, dict(arguments or {}))
