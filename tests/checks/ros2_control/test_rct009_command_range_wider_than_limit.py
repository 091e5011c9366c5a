from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control
from tests.reported import messages, places, reported


def commanded(name: str, interface: str, least: str, greatest: str) -> str:
    """A joint with a range, on one line."""
    return (
        f'<joint name="{name}"><command_interface name="{interface}"><param name="min">{least}'
        f'</param><param name="max">{greatest}</param></command_interface></joint>'
    )


@pytest.mark.parametrize(
    ("joint", "message"),
    [
        (
            commanded("slide", "position", "0", "0.6"),
            (
                "joint 'slide': the range of command_interface 'position', [0, 0.6] m, exceeds the "
                "joint limit [0, 0.5] m"
            ),
        ),
        (
            commanded("swing", "velocity", "-3", "3"),
            (
                "joint 'swing': the range of command_interface 'velocity', [-3, 3] rad/s, "
                "exceeds the joint limit [-2, 2] rad/s"
            ),
        ),
        (
            commanded("slide", "effort", "-200", "x"),
            (
                "joint 'slide': the range of command_interface 'effort', [-200, ...] N, "
                "exceeds the joint limit [-100, 100] N"
            ),
        ),
    ],
)
def test_wider(joint: str, message: str) -> None:
    assert messages("RCT009", ROBOT + control(joint)) == [message]


def test_the_place_is_the_bound_that_is_outside() -> None:
    text = ROBOT + control(commanded("slide", "position", "0", "0.6"))
    assert places("RCT009", text) == [(NEXT + 2, '<param name="max">')]
    text = text.replace(">0<", ">-0.1<")
    assert places("RCT009", text) == [(NEXT + 2, '<param name="min">')]


def test_one_block_is_one_finding() -> None:
    joints = [commanded("slide", "position", "-1", "1"), commanded("swing", "velocity", "-9", "9")]
    (found,) = reported("RCT009", ROBOT + control(*joints))
    assert found.message.endswith(", and 1 more in <ros2_control> 'c'")
    assert [related.span.line for related in found.related] == [NEXT + 3]


@pytest.mark.parametrize(
    "joint",
    [
        commanded("slide", "position", "0.1", "0.5"),
        commanded("slide", "position", "-0.004", "0.504"),  # rounded
        commanded("swing", "position", "-9", "9"),  # without end
        commanded("slide", "acceleration", "-9", "9"),
        commanded("nobody", "position", "-9", "9"),
        commanded("slide", "position", "", "text"),
        '<joint name="slide"><command_interface name="position"/></joint>',
    ],
)
def test_within(joint: str) -> None:
    assert reported("RCT009", ROBOT + control(joint)) == []
