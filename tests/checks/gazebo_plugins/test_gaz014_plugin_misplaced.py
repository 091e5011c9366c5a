from __future__ import annotations

import pytest

from tests.gazebos import BASE, block, plugin, sensor
from tests.reported import messages, reported

DRIVE = '<plugin name="p" filename="libgazebo_ros_planar_move.so"/>'
LASER = '<plugin name="p" filename="libgazebo_ros_laser.so"/>'
VENDOR = '<plugin name="p" filename="libvendor.so"/>'
SHADER = '<plugin name="p" filename="gz-sim-shader-param-system"/>'
MODEL = "a <gazebo> block without a reference"
SENSOR = "a <sensor> in the block of a link"
VISUAL = "a <visual> in the block of a link"


@pytest.mark.parametrize(
    ("text", "file", "message"),
    [
        (block(DRIVE), "gazebo_ros_planar_move", "the block of 'base', where Gazebo never runs it"),
        (block(VENDOR), "vendor", "the block of 'base', where Gazebo never runs it"),
        (block(LASER, ""), "gazebo_ros_laser", f"{MODEL}, and is for a sensor"),
        (sensor("ray", DRIVE), "gazebo_ros_planar_move", f"{SENSOR}, and is for a model"),
        (
            plugin("libgazebo_ros_init.so"),
            "gazebo_ros_init",
            f"{MODEL}, and is for a system",
        ),
        (block(f"<visual>{LASER}</visual>"), "gazebo_ros_laser", f"{VISUAL}, and is for a sensor"),
    ],
)
def test_the_wrong_place(text: str, file: str, message: str) -> None:
    heard = f"plugin 'p' (lib{file}.so) stands in {message}"
    assert messages("GAZ014", BASE + text) == [heard]


@pytest.mark.parametrize(
    "text",
    [
        block(DRIVE, ""),
        sensor("ray", LASER),
        sensor("ray", VENDOR),
        block(VENDOR, ""),
        block(f"<visual>{SHADER}</visual>"),
        plugin("gz-sim-sensors-system"),  # gz-sim runs a world's system in a model, too
        sensor("imu", '<plugin name="p" filename="gz-sim-imu-system"/>'),  # and in a sensor
        block(DRIVE, "nothing"),  # the whole block is lost
    ],
)
def test_the_right_place(text: str) -> None:
    assert reported("GAZ014", BASE + text) == []
