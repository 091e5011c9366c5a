from __future__ import annotations

import pytest

from tests.gazebos import BASE
from tests.reported import fixed, messages, reported


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ('filename="libx.so"', ["plugin libx.so has no name: Gazebo refuses the model"]),
        ('filename="libx.so" name=" "', ["plugin libx.so has no name: Gazebo refuses the model"]),
        ('name="x"', ["plugin 'x' has no filename: Gazebo refuses the model"]),
        (
            "",
            [
                "a plugin has no filename: Gazebo refuses the model",
                "a plugin has no name: Gazebo refuses the model",
            ],
        ),
        ('name="x" filename="libx.so"', []),
    ],
)
def test_both_are_required(attributes: str, expected: list[str]) -> None:
    assert messages("GAZ010", BASE + f"<gazebo><plugin {attributes}/></gazebo>") == expected


def test_the_hardware_plugin_of_ros2_control_has_neither() -> None:
    hardware = "<hardware><plugin>gz_ros2_control/GazeboSimSystem</plugin></hardware>"
    text = f'{BASE}<ros2_control name="c" type="system">{hardware}</ros2_control>'
    assert reported("GAZ010", text) == []


def test_a_plugin_is_named_after_its_library() -> None:
    text = BASE + '<gazebo><plugin filename="libgazebo_ros_x.so"/></gazebo>'
    assert '<plugin name="gazebo_ros_x" filename="libgazebo_ros_x.so"/>' in fixed("GAZ010", text)


@pytest.mark.parametrize(
    "plugins",
    [
        '<plugin name="" filename="libx.so"/>',  # a second attribute of that name would be no XML
        '<plugin filename="libx.so"/><plugin name="x" filename="liby.so"/>',  # taken
        '<plugin filename="gz-sim-imu-system"/>',  # no name of a ROS node
        '<plugin name="x"/>',
    ],
)
def test_no_fix(plugins: str) -> None:
    assert [one.fix for one in reported("GAZ010", f"{BASE}<gazebo>{plugins}</gazebo>")] == [None]
