"""LAU028: see the rule; planted defects are in tests/bringup/planted.txt."""

from pathlib import Path

import pytest

from tests.checks.bringup.nav2 import EKF, rows
from tests.launched import reported


@pytest.mark.parametrize(
    ("package", "executable", "old", "count"),
    [
        ("controller_manager", "spawner", "/drive/cmd_vel", 1),
        ("controller_manager", "spawner", "~/cmd_vel", 1),
        ("controller_manager", "spawner", "/controller_manager/list_controllers", 0),
        ("controller_manager", "ros2_control_node", "/drive/cmd_vel", 0),
        ("robot_state_publisher", "robot_state_publisher", "/drive/cmd_vel", 1),
        ("robot_state_publisher", "robot_state_publisher", "/joint_states", 0),
    ],
)
def test_remappings_of_a_controller(
    tmp_path: Path, package: str, executable: str, old: str, count: int
) -> None:
    node = 'Node(package="{}", executable="{}", arguments=["drive"], remappings=[("{}", "/x")])'
    other = 'Node(package="controller_manager", executable="spawner", arguments=["drive"])'
    nodes = f"{node.format(package, executable, old)}, {other}"
    text = f"from launch_ros.actions import Node\n\nnodes = [{nodes}]\n"
    found = reported(tmp_path / "arm", "LAU028", "a.launch.py", text)
    words = f"remapping of '{old}'"
    assert [one.message.partition(" has")[0] for one in found] == [words] * count


@pytest.mark.parametrize(("to", "count"), [("cmd_vel", 1), ("/cmd_vel", 1), ("drive/cmd_vel", 0)])
def test_a_multiplexer_that_reads_its_output(tmp_path: Path, to: str, count: int) -> None:
    text = (
        '<node pkg="twist_mux" exec="twist_mux" name="twist_mux">\n'
        '<param from="$(dirname)/../mux.yaml"/>\n'
        f'<remap from="cmd_vel_out" to="{to}"/>\n</node>'
    )
    entry = "{topic: cmd_vel, timeout: 0.5, priority: 10}"
    files = {"mux.yaml": f"twist_mux: {{ros__parameters: {{topics: {{navigation: {entry}}}}}}}\n"}
    found = reported(tmp_path / "arm", "LAU028", "a.launch.xml", text, files)
    assert ["own output" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("to", "count"), [("odom", 1), ("/odom", 1), ("odom/filtered", 0)])
def test_a_filter_that_reads_its_output(tmp_path: Path, to: str, count: int) -> None:
    text = (
        '<node pkg="robot_localization" exec="ekf_node" name="ekf">\n'
        '<param from="$(dirname)/../ekf.yaml"/>\n'
        f'<remap from="odometry/filtered" to="{to}"/>\n</node>'
    )
    files = {"ekf.yaml": EKF.format(f"odom0: odom, odom0_config: {rows(2)}")}
    found = reported(tmp_path / "arm", "LAU028", "a.launch.xml", text, files)
    assert ["own output" in one.message for one in found] == [True] * count


DRIVES = "controller_manager: {ros__parameters: {drive: {type: diff_drive_controller/%s}}}\n"


@pytest.mark.parametrize(
    ("kind", "remapped", "count"),
    [
        ("DiffDriveController", "/base/cmd_vel", 1),
        ("DiffDriveController", "/drive/cmd_vel", 0),
        ("DiffDriveController", "/base/own", 0),
        ("DiffDriveController", '/drive/cmd_vel", "/a"), ("/base/cmd_vel', 0),  # for another one
        ("Own", "/base/cmd_vel", 0),
    ],
)
def test_a_remapping_for_another_drive(
    tmp_path: Path, kind: str, remapped: str, count: int
) -> None:
    node = (
        'Node(package="controller_manager", executable="ros2_control_node", '
        f'parameters=["../c.yaml"], remappings=[("{remapped}", "/x")])'
    )
    text = f"from launch_ros.actions import Node\n\nnodes = [{node}]\n"
    files = {"c.yaml": DRIVES % kind}
    found = reported(tmp_path / "arm", "LAU028", "a.launch.py", text, files)
    assert ["no controller is called 'base'" in one.message for one in found] == [True] * count
