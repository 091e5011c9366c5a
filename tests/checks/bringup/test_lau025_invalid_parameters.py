"""LAU025: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import (
    AMCL,
    CONTROLLER,
    EKF,
    PLAIN_MPPI,
    PROGRAM,
    SERVER,
    WATCH,
    messages,
    rows,
)
from tests.launched import reported
from urdfkit import Severity

POLYGON = "collision_monitor: {{ros__parameters: {{polygons: [near], near: {{{}}}}}}}\n"
SQUARE = "points: '[[1, 1], [1, -1], [-1, -1], [-1, 1]]'"


@pytest.mark.parametrize(
    ("polygon", "words"),
    [
        (f"type: polygon, {SQUARE}", []),
        ("type: polygon, polygon_sub_topic: shape", []),
        ("type: polygon, action_type: approach", []),
        ("type: polygon, action_type: stop", ["no points"]),
        ("type: polygon, points: '[[1, 1], [1, -1], [-1, -1]]'", ["3 points"]),
        ("type: polygon, points: $(var points)", []),
        ("type: circle, radius: 0.3", []),
        ("type: circle", ["no radius"]),
        ("type: velocity_polygon, velocity_polygons: [slow]", []),
        (f"type: velocity_polygon, {SQUARE}", ["no velocity_polygons"]),
        ("enabled: true", []),
    ],
)
def test_polygons(tmp_path: Path, polygon: str, words: list[str]) -> None:
    node = 'package="nav2_collision_monitor", executable="collision_monitor", '
    node += 'parameters=["../a.yaml"]'
    found = messages("LAU025", tmp_path, POLYGON.format(polygon), node, '"collision_monitor"')
    found = [one for one in found if "observation_sources" not in one]
    assert [word in one for word, one in zip(words, found, strict=True)] == [True] * len(words)


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
    assert len([one for one in found if "robot_model_type" in one.message]) == count


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
    found = [one for one in found if "must not be" in one.message]
    assert [(one.help, one.severity.value) for one in found] == [(help, severity)] * bool(help)


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
        ("a: [[1, 2], [3, 4]]", "list of lists"),
        ("a: [[1, 2]]", ""),  # read as a flat list
    ],
)
def test_types(tmp_path: Path, value: str, message: str) -> None:
    yaml = f"controller_server:\n  ros__parameters:\n    {value}\n"
    found = messages("LAU025", tmp_path, yaml)
    found = [one for one in found if "values, not 15" not in one]
    assert [message in one for one in found] == [True] * bool(message)


@pytest.mark.parametrize(("value", "count"), [("30.0", 0), ("30", 1), ("rate", 0)])
def test_how_often_the_state_is_published(tmp_path: Path, value: str, count: int) -> None:
    node = (
        'package="robot_state_publisher", executable="robot_state_publisher", '
        f'parameters=[{{"publish_frequency": {value}}}]'
    )
    found = messages("LAU025", tmp_path, "", node, "")
    assert ["is an integer" in one for one in found] == [True] * count
    yaml = f"robot_state_publisher:\n  ros__parameters: {{publish_frequency: {value}}}\n"
    node = node.partition("parameters")[0] + 'parameters=["../a.yaml"]'
    found = messages("LAU025", tmp_path, yaml, node, "")
    assert ["be a number" in one for one in found] == [True] * (value != "30.0")


@pytest.mark.parametrize(("width", "count"), [("3", 0), ("3.0", 1), ("$(var width)", 0)])
def test_the_size_of_a_costmap(tmp_path: Path, width: str, count: int) -> None:
    yaml = f"local_costmap:\n  local_costmap:\n    ros__parameters:\n      width: {width}\n"
    found = messages("LAU025", tmp_path, yaml)
    assert ["as an integer" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("yaml", "words"),
    [
        (SERVER.format(f"{PLAIN_MPPI}, motion_model: Diff"), "unknown motion_model 'Diff'"),
        (WATCH.format("near", "cirle"), "unknown type 'cirle'"),
        (AMCL.format("global_frame_id: odom"), "global_frame_id is 'odom'"),
        (AMCL.format("global_frame_id: map, odom_frame_id: odom"), ""),
    ],
)
def test_values_of_nav2(tmp_path: Path, yaml: str, words: str) -> None:
    found = messages("LAU025", tmp_path, yaml)
    found = [one for one in found if "model_dt" not in one]
    assert [words in one for one in found] == [True] * bool(words)


MUX = "twist_mux: {{ros__parameters: {{topics: {{joy: {{{}}}}}, use_stamped: true}}}}\n"
SLAM = "slam_toolbox: {{ros__parameters: {{{}}}}}\n"
TELEOP = "teleop_twist_joy_node: {{ros__parameters: {{scale_linear: {{x: {}}}}}}}\n"


@pytest.mark.parametrize(
    ("yaml", "count"),
    [
        (MUX.format("topic: joy, timeout: 0.5, priority: 1"), 0),
        (MUX.format("topic: joy, timeout: 1, priority: 1"), 1),
        (MUX.format("topic: joy, timeout: 1.0"), 1),
        (TELEOP.format("0.5"), 0),
        (TELEOP.format("1"), 1),
        (SLAM.format("max_laser_range: 20"), 1),
        (SLAM.format("solver_plugin: solver_plugins::CeresSolver"), 0),
        (SLAM.format("solver_plugin: solver_plugins::MySolver"), 1),
        (SLAM.format("solver_plugin: solver_plugin::CeresSolver"), 1),
        (SLAM.format("solver_plugin: CeresSolver"), 1),
        # Isaac_Sim_ROS2_Nav has its own.
        (SLAM.format("solver_plugin: robot_slam_solver::ConfigurableCeresSolver"), 0),
        (EKF.format(f"frequency: 30, odom0: odom, odom0_config: {rows(2)}"), 1),
    ],
)
def test_parameters_of_other_nodes(tmp_path: Path, yaml: str, count: int) -> None:
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
    assert [one.help for one in found if "frame_prefix" in one.message] == [help] * bool(help)


def test_a_mode_that_slam_toolbox_does_not_have(tmp_path: Path) -> None:
    """It maps in every mode but localization; the node does not stop."""
    node = '<node pkg="slam_toolbox" exec="sync_slam_toolbox_node" name="slam_toolbox">'
    node += '<param from="$(dirname)/../a.yaml"/></node>'
    yaml = SLAM.format("mode: online_async")
    (found,) = reported(tmp_path / "arm", "LAU025", "a.launch.xml", node, {"a.yaml": yaml})
    assert found.severity is Severity.WARNING
