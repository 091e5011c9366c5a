from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import fixed, messages, reported
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.ros.catalog import plugins

DRIVE = "libgazebo_ros_diff_drive.so"


@pytest.mark.parametrize(
    ("file", "suggested"),
    [
        ("libgazebo_ros_diffdrive.so", DRIVE),
        ("libgazebo_ros_diff_drvie.so", DRIVE),
        ("libgazebo_ros_diff_driver.so", DRIVE),
        ("libgazebo_ros_diff-drive.so", DRIVE),
        ("gazebo_ros_diff_drive", DRIVE),
        ("libgazebo_ros2_controll.so", "libgazebo_ros2_control.so"),
        ("gz-sim-imu-sytem", "gz-sim-imu-system"),
    ],
)
def test_a_slip_is_told_and_mended(file: str, suggested: str) -> None:
    text = BASE + plugin(file)
    (message,) = messages("GAZ070", text)
    assert f"'{file}' is nearly '{suggested}'" in message
    assert fixed("GAZ070", text) == whole_robot(BASE + plugin(suggested))


@pytest.mark.parametrize(
    "file",
    [
        "libvendor.so",
        "libgazebo_ros_diff_drive2.so",
        "libgazebo_ros_srp.so",
        "libroboticsgroup_gazebo_disable_link_plugin.so",
        "",
    ],
)
def test_a_library_of_a_vendor_is_none(file: str) -> None:
    assert reported("GAZ070", BASE + plugin(file)) == []


def test_no_library_of_the_catalogue_is_one() -> None:
    assert reported("GAZ070", BASE + "".join(plugin(file) for file in plugins.files())) == []
