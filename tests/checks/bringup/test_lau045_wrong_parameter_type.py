"""LAU045: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import EKF, PROGRAM, messages, rows
from tests.launched import reported
from urdfkit import Severity

MUX = "twist_mux: {{ros__parameters: {{topics: {{joy: {{{}}}}}, use_stamped: true}}}}\n"
SLAM = "slam_toolbox: {{ros__parameters: {{{}}}}}\n"
TELEOP = "teleop_twist_joy_node: {{ros__parameters: {{scale_linear: {{x: {}}}}}}}\n"


@pytest.mark.parametrize(
    ("value", "message"),
    [
        ("controller_frequency: 20", "controller_frequency is an integer"),
        ("controller_frequency: -20", "controller_frequency is an integer"),
        ("controller_frequency: 20.0", ""),
        ("controller_frequency: '20'", "controller_frequency is a string"),
        ("controller_frequency: $(var rate)", ""),
        ("publish_zero_velocity: 1", "publish_zero_velocity is an integer"),
        ("a: {plugin: own::Controller, yaw_goal_tolerance: 1}", ""),
        ("a: {plugin: nav2_controller::SimpleGoalChecker, yaw_goal_tolerance: 1}", "an integer"),
        ("min_particles: 20", ""),
        ("frequency: 20", ""),  # of a filter alone
        ("frequency: 20\n    odom0_config: []", "frequency is an"),
    ],
)
def test_types(tmp_path: Path, value: str, message: str) -> None:
    yaml = f"controller_server:\n  ros__parameters:\n    {value}\n"
    found = messages("LAU045", tmp_path, yaml)
    assert [message in one for one in found] == [True] * bool(message)


@pytest.mark.parametrize(("value", "count"), [("30.0", 0), ("30", 1), ("rate", 0)])
def test_how_often_the_state_is_published(tmp_path: Path, value: str, count: int) -> None:
    node = (
        'package="robot_state_publisher", executable="robot_state_publisher", '
        f'parameters=[{{"publish_frequency": {value}}}]'
    )
    found = messages("LAU045", tmp_path, "", node, "")
    assert ["is an integer" in one for one in found] == [True] * count
    yaml = f"robot_state_publisher:\n  ros__parameters: {{publish_frequency: {value}}}\n"
    node = node.partition("parameters")[0] + 'parameters=["../a.yaml"]'
    found = messages("LAU045", tmp_path, yaml, node, "")
    assert ["be a number" in one for one in found] == [True] * (value != "30.0")


@pytest.mark.parametrize(("width", "count"), [("3", 0), ("3.0", 1), ("$(var width)", 0)])
def test_the_size_of_a_costmap(tmp_path: Path, width: str, count: int) -> None:
    yaml = f"local_costmap:\n  local_costmap:\n    ros__parameters:\n      width: {width}\n"
    found = messages("LAU045", tmp_path, yaml)
    assert ["as an integer" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("yaml", "count"),
    [
        (MUX.format("topic: joy, timeout: 0.5, priority: 1"), 0),
        (MUX.format("topic: joy, timeout: 1, priority: 1"), 1),
        (MUX.format("topic: joy, timeout: 1.0"), 0),
        (TELEOP.format("0.5"), 0),
        (TELEOP.format("1"), 1),
        (SLAM.format("max_laser_range: 20"), 1),
        (EKF.format(f"frequency: 30, odom0: odom, odom0_config: {rows(2)}"), 1),
    ],
)
def test_parameters_of_other_nodes(tmp_path: Path, yaml: str, count: int) -> None:
    assert len(messages("LAU045", tmp_path, yaml)) == count


@pytest.mark.parametrize(
    ("value", "severity", "words"),
    [
        ("2000", Severity.WARNING, "write 2.0"),  # the timeout of Foxy, in ms
        ("5", Severity.ERROR, "write 5.0"),
    ],
)
def test_the_timeout_of_the_map_saver(
    tmp_path: Path, value: str, severity: Severity, words: str
) -> None:
    node = 'package="nav2_map_server", executable="map_saver_server", '
    node += f'parameters=[{{"save_map_timeout": {value}}}]'
    text = PROGRAM.format(node, "")
    (one,) = reported(tmp_path / "arm", "LAU045", "a.launch.py", text)
    assert (one.severity, one.help) == (severity, words)
