"""RCT009: see the rule."""

import pytest

from tests.controls import NEXT, ROBOT, control
from tests.naming import naming
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
            commanded("slide", "position", "0", "0.506"),
            naming("slide", "command_interface", "position", "[0, 0.506] m", "[0, 0.5] m"),
        ),
        (
            commanded("swing", "velocity", "-3", "3"),
            naming("swing", "command_interface", "velocity", "[-3, 3] rad/s", "[-2, 2] rad/s"),
        ),
        (
            commanded("slide", "effort", "-200", "x"),
            naming("slide", "command_interface", "effort", "-200", "[-100, 100] N"),
        ),
    ],
)
def test_wider(joint: str, message: str) -> None:
    assert messages("RCT009", ROBOT + control(joint)) == [message]


def test_location_is_the_bound_outside_the_limit() -> None:
    text = ROBOT + control(commanded("slide", "position", "0", "0.6"))
    assert places("RCT009", text) == [(NEXT + 2, '<param name="max">')]
    text = text.replace(">0<", ">-0.1<")
    assert places("RCT009", text) == [(NEXT + 2, '<param name="min">')]


def test_one_block_is_one_finding() -> None:
    joints = [commanded("slide", "position", "-1", "1"), commanded("swing", "velocity", "-9", "9")]
    (found,) = reported("RCT009", ROBOT + control(*joints))
    assert found.message == naming(
        "slide",
        "command_interface",
        "position",
        "[-1, 1] m",
        "[0, 0.5] m",
        "1",
        "<ros2_control>",
        "c",
    )
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


def test_swapped() -> None:
    outside = ROBOT + control(commanded("slide", "position", "0.6", "0"))
    assert messages("RCT009", outside) == [naming("slide", "0.6", "0")]
    text = ROBOT + control(commanded("slide", "position", "0.5", "0"))
    assert messages("RCT009", text) == [naming("slide", "0.5", "0")]
    assert places("RCT009", text) == [(NEXT + 2, '<param name="min">')]


def test_sign_error() -> None:
    text = ROBOT + control(commanded("slide", "effort", "-500", "-500"))
    assert messages("RCT009", text) == [naming("slide", "effort", "both", "-500")]
    assert messages("RCT009", ROBOT + control(commanded("slide", "effort", "0", "0"))) == []
    (swapped,) = messages("RCT009", ROBOT + control(commanded("slide", "position", "0", "-0.5")))
    assert swapped.endswith("min 0 > max -0.5")


def test_of_a_gpio() -> None:
    text = commanded("lamp", "analog", "5", "-5").replace("joint", "gpio")
    (message,) = messages("RCT009", ROBOT + control(text))
    assert message.startswith("gpio 'lamp', ")


def test_ranges_that_are_not_empty() -> None:
    for least, greatest in [("0", "0"), ("0", "0.5"), ("x", "0.5"), ("0.5", "")]:
        assert (
            reported("RCT009", ROBOT + control(commanded("slide", "position", least, greatest)))
            == []
        )


def starting(name: str, interface: str, value: str) -> str:
    """A joint with a state, on one line."""
    return (
        f'<joint name="{name}"><state_interface name="{interface}">'
        f'<param name="initial_value">{value}</param></state_interface></joint>'
    )


def test_outside() -> None:
    text = ROBOT + control(starting("slide", "position", "0.6"))
    assert messages("RCT009", text) == [
        naming("slide", "initial_value", "0.6 m", "outside", "[0, 0.5] m")
    ]
    assert places("RCT009", text) == [(NEXT + 2, '<param name="initial_value">')]


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
    assert reported("RCT009", ROBOT + control(starting(name, interface, value))) == []
