from __future__ import annotations

import pytest

from tests.gazebos import BASE
from tests.told import messages, told


@pytest.mark.parametrize(
    ("attributes", "expected"),
    [
        ('filename="libx.so"', ["plugin libx.so has no name: Gazebo refuses the model"]),
        ('filename="libx.so" name=" "', ["plugin libx.so has no name: Gazebo refuses the model"]),
        ('name="x"', ["plugin 'x' has no filename: Gazebo refuses the model"]),
        (
            "",
            [
                "plugin  has no name: Gazebo refuses the model",
                "plugin '' has no filename: Gazebo refuses the model",
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
    assert told("GAZ010", text) == []
