from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control
from tests.reported import messages, places, reported


def starting(name: str, interface: str, value: str) -> str:
    """A joint with a state, on one line."""
    return (
        f'<joint name="{name}"><state_interface name="{interface}">'
        f'<param name="initial_value">{value}</param></state_interface></joint>'
    )


def test_outside() -> None:
    text = ROBOT + control(starting("slide", "position", "0.6"))
    assert messages("RCT020", text) == ["joint 'slide' starts at 0.6 m, its limit is 0 to 0.5 m"]
    assert places("RCT020", text) == [(NEXT + 2, '<param name="initial_value">')]


@pytest.mark.parametrize(
    ("name", "interface", "value"),
    [
        ("slide", "position", "0.5"),
        ("slide", "position", "0.5005"),
        ("slide", "velocity", "9"),
        ("slide", "position", "x"),
        ("swing", "position", "9"),
        ("nobody", "position", "9"),
    ],
)
def test_within_or_without_limits(name: str, interface: str, value: str) -> None:
    assert reported("RCT020", ROBOT + control(starting(name, interface, value))) == []
