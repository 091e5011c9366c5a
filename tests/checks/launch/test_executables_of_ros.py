"""LAU003: executables that a package of ROS does not have."""

from pathlib import Path

import pytest

from tests.launched import reported


@pytest.mark.parametrize(
    ("package", "name", "help"),
    [
        ("joint_state_publisher", "joint_state_publisher_gui", "joint_state_publisher_gui"),
        ("joint_state_publisher", "joint_state_publisher", ""),
        ("robot_localization", "ekf_localization_node", "one of"),
    ],
)
def test_an_executable_of_another_package(
    tmp_path: Path, package: str, name: str, help: str
) -> None:
    text = f'<node pkg="{package}" exec="{name}"/>'
    found = reported(tmp_path, "LAU003", "a.launch.xml", text)
    assert [help in one.help for one in found] == [True] * bool(help)
