"""LAU025: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    AMCL,
    CONTROLLER,
    PLAIN_MPPI,
    PROGRAM,
    SERVER,
    WATCH,
    messages,
)
from tests.launched import reported
from urdfkit import Severity

SLAM = "slam_toolbox: {{ros__parameters: {{{}}}}}\n"


@pytest.mark.parametrize(
    ("load", "count"),
    [
        ('<rosparam file="$(dirname)/../a.yaml" command="load"/>', 0),
        ('<param from="$(dirname)/../a.yaml"/>', 1),
    ],
)
def test_a_file_of_ros2_that_ros1_loads(tmp_path: Path, load: str, count: int) -> None:
    """stretch_ros: AMCL of ROS 1 and its file of ROS 2, of which it reads nothing."""
    node = f'<node pkg="nav2_amcl" exec="amcl" type="amcl" name="amcl">{load}</node>'
    yaml = "amcl:\n  ros__parameters: {robot_model_type: differential}\n"
    found = reported(tmp_path / "arm", "LAU025", "a.launch", node, {"a.yaml": yaml})
    assert len(found) == count


@pytest.mark.parametrize(
    ("values", "help", "severity"),
    [
        ("max_decel: [-1.0, 0.0, -2.0]", "", ""),
        ("max_decel: [-1.0, 0.0, 2.0]", "write -2.0", "error"),
        ("max_accel: [1.0, -0.5, 2.0]", "write 0.5", "error"),
        ("min_velocity: [0.1, 0.0, -1.0]", "write -0.1", "warning"),
        ("min_velocity: [0.0, 0.0, -1.0]", "", ""),
    ],
)
def test_signs_of_limits(tmp_path: Path, values: str, help: str, severity: str) -> None:
    yaml = f"velocity_smoother:\n  ros__parameters:\n    {values}\n"
    text = PROGRAM.format(CONTROLLER, '"controller_server"')
    found = reported(tmp_path / "arm", "LAU025", "a.launch.py", text, {"a.yaml": yaml})
    assert [(one.help, one.severity.value) for one in found] == [(help, severity)] * bool(help)


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (SERVER.format(f"{PLAIN_MPPI}, motion_model: Diff"), "unknown motion_model 'Diff'"),
        (
            SERVER.format(f"{PLAIN_MPPI}, motion_model: own, own: {{plugin: 'p::Own'}}"),
            "",  # as Nav2 has it since Lyrical
        ),
        (WATCH.format("near", "cirle"), "unknown type 'cirle'"),
        (AMCL.format("global_frame_id: odom"), "global_frame_id is 'odom'"),
        (AMCL.format("global_frame_id: map, odom_frame_id: odom"), ""),
    ],
)
def test_values_of_nav2(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages("LAU025", tmp_path, yaml)
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("yaml", "count"),
    [
        (SLAM.format("solver_plugin: solver_plugins::CeresSolver"), 0),
        (SLAM.format("solver_plugin: solver_plugins::MySolver"), 1),
        (SLAM.format("solver_plugin: solver_plugin::CeresSolver"), 1),
        (SLAM.format("solver_plugin: CeresSolver"), 1),
        # Isaac_Sim_ROS2_Nav has its own.
        (SLAM.format("solver_plugin: robot_slam_solver::ConfigurableCeresSolver"), 0),
    ],
)
def test_solvers_of_slam_toolbox(tmp_path: Path, yaml: str, count: int) -> None:
    assert len(messages("LAU025", tmp_path, yaml)) == count


@pytest.mark.parametrize(
    ("prefix", "namespace", "help"),
    [
        ("one", "one", "write one/"),
        ("one", "/one", "write one/"),
        ("one/", "one", ""),
        ("one_", "one", ""),
        ("one", "two", ""),
        ("/", "", ""),  # tf2 strips it
        ("/one", "one", "write one/"),
        ("", "one", ""),
    ],
)
def test_prefixes_of_frames(tmp_path: Path, prefix: str, namespace: str, help: str) -> None:
    node = (
        f'<node pkg="robot_state_publisher" exec="robot_state_publisher" namespace="{namespace}">'
        f'<param name="frame_prefix" value="{prefix}"/></node>'
    )
    found = reported(tmp_path / "arm", "LAU025", "a.launch.xml", node)
    assert [one.help for one in found] == [help] * bool(help)


def test_a_mode_that_slam_toolbox_does_not_have(tmp_path: Path) -> None:
    """It maps in every mode but localization; the node does not stop."""
    node = '<node pkg="slam_toolbox" exec="sync_slam_toolbox_node" name="slam_toolbox">'
    node += '<param from="$(dirname)/../a.yaml"/></node>'
    yaml = SLAM.format("mode: online_async")
    (found,) = reported(tmp_path / "arm", "LAU025", "a.launch.xml", node, {"a.yaml": yaml})
    assert found.severity is Severity.WARNING
