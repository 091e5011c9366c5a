from __future__ import annotations

import pytest

from tests.controls import CLASSIC, GZ, MOCK, NEXT, ROBOT, control, driven, plugin
from tests.reported import messages, places, reported

LOADS_CLASSIC = plugin("libgazebo_ros2_control.so")
LOADS_GZ = plugin("libgz_ros2_control-system.so")


def test_classic_hardware_for_gz() -> None:
    text = ROBOT + control(driven("swing"), plugin=CLASSIC) + LOADS_GZ
    assert messages("RCT011", text) == [
        (
            "<ros2_control> 'c': hardware plugin gazebo_ros2_control/GazeboSystem is not one that "
            "libgz_ros2_control-system.so loads "
            "(gz_ros2_control/GazeboSimSystem or ign_ros2_control/IgnitionSystem)"
        )
    ]
    assert places("RCT011", text) == [(NEXT + 1, "<plugin>")]
    (found,) = reported("RCT011", text)
    assert [(one.span.line, one.message) for one in found.related] == [
        (NEXT + 4, "the control plugin")
    ]


def test_gz_hardware_for_classic_and_for_ros1() -> None:
    text = ROBOT + control(driven("swing"), plugin=GZ)
    (message,) = messages("RCT011", text + LOADS_CLASSIC)
    assert message.endswith("libgazebo_ros2_control.so loads (gazebo_ros2_control/GazeboSystem)")
    (message,) = messages("RCT011", text + plugin("libgazebo_ros_control.so"))
    assert message.endswith("is not one that libgazebo_ros_control.so loads")


@pytest.mark.parametrize(
    ("hardware", "plugins"),
    [
        (CLASSIC, LOADS_CLASSIC),
        (GZ, LOADS_GZ),
        ("ign_ros2_control/IgnitionSystem", LOADS_GZ),
        (GZ, plugin("ign_ros2_control-system")),
        (GZ, LOADS_CLASSIC + LOADS_GZ),
        (GZ, ""),  # RCT010
        (MOCK, LOADS_GZ),  # the real robot, described with Gazebo's blocks left in
        ("acme/Sim", LOADS_GZ),
    ],
)
def test_what_fits_or_is_unknown(hardware: str, plugins: str) -> None:
    assert reported("RCT011", ROBOT + control(driven("swing"), plugin=hardware) + plugins) == []
