"""Launch files with the nodes of Nav2, and their parameter files, for the tests."""

from pathlib import Path

from tests.launched import reported
from urdfkit import Diagnostic

PROGRAM = """\
from launch_ros.actions import Node

nodes = [
    Node({}),
    Node(package="nav2_lifecycle_manager", executable="lifecycle_manager", name="manager",
         parameters=[{{"autostart": True, "node_names": [{}]}}]),
]
"""
CONTROLLER = 'package="nav2_controller", executable="controller_server", parameters=["../a.yaml"]'
PARAMETERS = "{}:\n  ros__parameters:\n    rate: 1.0\n"
COSTMAP = "local_costmap:\n  local_costmap:\n    ros__parameters:\n      {}\n"
COSTMAP_OF = "local_costmap: {{local_costmap: {{ros__parameters: {{{}}}}}}}\n"
AMCL = "amcl: {{ros__parameters: {{{}}}}}\n"
EKF = "ekf: {{ros__parameters: {{{}}}}}\n"
JAZZY = "behavior_server: {ros__parameters: {spin: {plugin: 'nav2_behaviors::Spin'}}}\n"
SERVER = "controller_server: {{ros__parameters: {{FollowPath: {{plugin: {}}}}}}}\n"
DWB, PLAIN_MPPI = "'dwb_core::DWBLocalPlanner'", "'nav2_mppi_controller::MPPIController'"
WATCH = (
    "collision_monitor: {{ros__parameters: {{polygons: [{}], near: {{type: {}}}, "
    "observation_sources: [scan], scan: {{type: scan}}}}}}\n"
)


def messages(
    code: str,
    directory: Path,
    yaml: str,
    node: str = CONTROLLER,
    names: str = '"controller_server"',
) -> list[str]:
    """The messages of a rule about a node with the parameter file ``a.yaml``."""
    return [finding.message for finding in reported_of(code, directory, yaml, node, names)]


def reported_of(
    code: str,
    directory: Path,
    yaml: str,
    node: str = CONTROLLER,
    names: str = '"controller_server"',
) -> list[Diagnostic]:
    """The findings of a rule about a node with the parameter file ``a.yaml``.

    Args:
        code: of the rule.
        directory: becomes the workspace.
        yaml: the parameter file.
        node: arguments of ``Node``.
        names: of the nodes of the lifecycle manager.
    """
    text = PROGRAM.format(node, names)
    return reported(directory / "arm", code, "a.launch.py", text, {"a.yaml": yaml})


def rows(row: int) -> str:
    """A configuration of robot_localization that reads one row."""
    values = ["false"] * 3 * row + ["true"] * 3 + ["false"] * (12 - 3 * row)
    return f"[{', '.join(values[:15])}]"
