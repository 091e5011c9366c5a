"""RCT028: see the rule."""

import pytest

from tests.controls import GZ, MOCK, ROBOT, control
from tests.reported import fixed, messages


@pytest.mark.parametrize(
    ("name", "suggested"),
    [
        ("mock_component/GenericSystem", MOCK),
        ("gz_ros2_control/GazeboSimSytem", GZ),
        ("GazeboSimSystem", GZ),
    ],
)
def test_a_slip_is_told_and_mended(name: str, suggested: str) -> None:
    assert messages("RCT028", ROBOT + control(plugin=name)) == [
        f"<ros2_control> 'c': hardware '{name}' is nearly '{suggested}'"
    ]
    assert f"<plugin>{suggested}</plugin>" in fixed("RCT028", ROBOT + control(plugin=name))


@pytest.mark.parametrize(
    "name", [MOCK, GZ, "fake_components/GenericSystem", "our_hardware/OurSystem"]
)
def test_other_hardware_is_calm(name: str) -> None:
    assert messages("RCT028", ROBOT + control(plugin=name)) == []
