from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported

PLUGIN = "<plugin>mock_components/GenericSystem</plugin>"
GOOD = ROBOT + control(driven("swing"))


@pytest.mark.parametrize(
    ("old", "new", "message", "place"),
    [
        (
            f"<hardware>{PLUGIN}</hardware>",
            "",
            "<ros2_control> 'c' has no <hardware>",
            (NEXT, '<ros2_control name="c" type="system">'),
        ),
        (
            PLUGIN,
            "",
            "<ros2_control> 'c': its <hardware> has no <plugin>",
            (NEXT + 1, "<hardware>"),
        ),
        (
            PLUGIN,
            "<plugin> </plugin>",
            "<ros2_control> 'c': its <plugin> is empty",
            (NEXT + 1, "<plugin>"),
        ),
    ],
)
def test_hardware_without_plugin(old: str, new: str, message: str, place: tuple[int, str]) -> None:
    text = GOOD.replace(old, new)
    assert messages("RCT005", text) == [message]
    assert places("RCT005", text) == [place]
    assert reported("RCT005", GOOD) == []


def test_a_transmission_without_plugin() -> None:
    inner = '<transmission name="t">{}<joint name="swing" role="r"/></transmission>'
    assert messages("RCT005", ROBOT + control(driven("swing"), inner.format(""))) == [
        "transmission 't' names no <plugin>"
    ]
    given = inner.format("<plugin>transmission_interface/SimpleTransmission</plugin>")
    assert reported("RCT005", ROBOT + control(driven("swing"), given)) == []


@pytest.mark.parametrize(
    ("hardware", "number"),
    [
        (f'<hardware><xacro:if value="0">{PLUGIN}</xacro:if></hardware>', 0),
        (f'<xacro:unless value="1"><hardware>{PLUGIN}</hardware></xacro:unless>', 0),
        ('<hardware><xacro:if value="1"><param name="rate">5</param></xacro:if></hardware>', 1),
    ],
)
def test_the_choice_of_arguments(hardware: str, number: int) -> None:
    text = GOOD.replace(f"<hardware>{PLUGIN}</hardware>", hardware)
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{text}</robot>'
    assert len(reported("RCT005", robot)) == number
