from __future__ import annotations

from tests.checks.ros2_control.test_rct009_command_range_wider_than_limit import commanded
from tests.controls import NEXT, ROBOT, control
from tests.reported import messages, places, reported


def test_swapped() -> None:
    text = ROBOT + control(commanded("slide", "position", "0.5", "0"))
    assert messages("RCT019", text) == [
        "joint 'slide': the range of position ends at 0, below its beginning at 0.5"
    ]
    assert places("RCT019", text) == [(NEXT + 2, '<param name="min">')]


def test_of_a_gpio() -> None:
    text = commanded("lamp", "analog", "5", "-5").replace("joint", "gpio")
    (message,) = messages("RCT019", ROBOT + control(text))
    assert message.startswith("gpio 'lamp': ")


def test_ranges_that_hold_something() -> None:
    for least, greatest in [("0", "0"), ("-1", "1"), ("x", "1"), ("1", "")]:
        assert (
            reported("RCT019", ROBOT + control(commanded("slide", "position", least, greatest)))
            == []
        )
