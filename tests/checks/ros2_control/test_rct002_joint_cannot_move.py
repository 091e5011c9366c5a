from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control, driven, transmission
from tests.reported import messages, places, reported


def test_a_fixed_joint_in_ros2_control() -> None:
    text = ROBOT + control('<joint name="weld"><state_interface name="position"/></joint>')
    assert messages("RCT002", text) == ["<ros2_control> 'c' drives joint 'weld', which is fixed"]
    assert places("RCT002", text) == [(NEXT + 2, "weld")]


def test_a_fixed_joint_in_a_transmission() -> None:
    text = ROBOT + transmission("weld")
    assert messages("RCT002", text) == ["transmission 't' drives joint 'weld', which is fixed"]
    assert reported("RCT002", text, targets=("gz-harmonic",)) == []


@pytest.mark.parametrize("name", ["swing", "slide", "follow", "nobody", ""])
def test_joints_that_move_or_are_unknown(name: str) -> None:
    assert reported("RCT002", ROBOT + control(driven(name))) == []
    assert reported("RCT002", ROBOT + transmission(name)) == []


def test_a_vendor_s_interface_may_drive_nothing() -> None:
    joint = (
        '<transmission name="model"><type>franka_hw/FrankaModelInterface</type>'
        '<joint name="weld"><hardwareInterface>franka_hw/FrankaModelInterface'
        "</hardwareInterface></joint></transmission>"
    )
    assert reported("RCT002", ROBOT + joint) == []
