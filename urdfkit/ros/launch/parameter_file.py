"""A parameter file of ROS 2 that no launch file loads, as what a launch file starts with it.

Users name it on the command line: ``ros2 launch nav2_bringup navigation_launch.py params_file:=``.
"""

from functools import cache

from urdfkit.ros.catalog import data
from urdfkit.ros.launch.collect import Collector
from urdfkit.ros.launch.contents import PARAMETERS, GivenParameters, LaunchedFile, StartedProgram
from urdfkit.ros.node_parameters import NodeParameters, node_parameters
from urdfkit.text.source import Span

#: Packages whose launch files have an argument for the parameter file.
_STARTED_BY_HAND = ("nav2_", "slam_toolbox/")


def read(collector: Collector, file: LaunchedFile) -> None:
    """Add the parameter file, and the programs of Nav2 and slam_toolbox with a section in it."""
    collector.file(file.source.path, Span(file.source, 0, 0), PARAMETERS)
    collector.started += filter(None, map(_program, node_parameters(file.source)))


def _program(section: NodeParameters) -> StartedProgram | None:
    key = programs_by_node().get(section.name)
    if key is None:
        return None
    package, _, executable = key.partition("/")
    given = GivenParameters({}, files=(section.at.source.path,))
    return StartedProgram(
        package, executable, (), section.at, None, parameters=given, name=section.name
    )


@cache
def programs_by_node() -> dict[str, str]:
    """The programs of Nav2 and slam_toolbox, as package and executable, by the name of the node."""
    programs: dict[str, str] = data("node_parameters")["programs"]
    return {node: key for key, node in programs.items() if key.startswith(_STARTED_BY_HAND)}
