from __future__ import annotations

import pytest

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported

GPIO = '<gpio name="lamp"><param name="p">1</param><command_interface name="on"/></gpio>'
GOOD = ROBOT + control(driven("swing", more='<param name="p">1</param>'), GPIO)


def test_a_tag_that_stops_the_parser() -> None:
    text = ROBOT + control(driven("swing"), '<sensr name="imu"/>')
    assert messages("RCT017", text) == [
        "<ros2_control> may not hold <sensr>; did you mean 'sensor'?"
    ]
    assert places("RCT017", text) == [(NEXT + 3, '<sensr name="imu"/>')]


@pytest.mark.parametrize(
    ("old", "new", "tag"),
    [
        ('<joint name="swing">', "<joint>", "joint"),
        ('<gpio name="lamp">', '<gpio name="">', "gpio"),
        ('<command_interface name="on"/>', "<command_interface/>", "command_interface"),
        ('<param name="p">', "<param>", "param"),
        ('<ros2_control name="c"', "<ros2_control", "ros2_control"),
    ],
)
def test_a_name_that_is_missing(old: str, new: str, tag: str) -> None:
    assert old in GOOD
    found = messages("RCT017", GOOD.replace(old, new))
    assert set(found) == {f"<{tag}> has no name"}


def test_what_the_parser_takes() -> None:
    more = '<properties/><transmission name="t"><plugin>p/C</plugin></transmission>'
    assert reported("RCT017", GOOD) == []
    assert reported("RCT017", ROBOT + control(driven("swing"), more)) == []
    assert reported("RCT017", ROBOT + control(driven("swing", more="<limits/><own/>"))) == []
    assert reported("RCT017", ROBOT + control(driven("swing"), "<xacro:more/>")) == []


def test_an_actuator_has_one_joint() -> None:
    text = ROBOT + control(driven("swing"), driven("slide"), kind="actuator")
    assert messages("RCT017", text) == ["an actuator has one joint, and this one has 2"]
    assert places("RCT017", text) == [(NEXT, "actuator")]
    assert reported("RCT017", ROBOT + control(driven("swing"), kind="actuator")) == []


def test_the_parts_of_a_transmission_have_roles() -> None:
    inside = '<plugin>p/C</plugin><joint name="swing" role="{}"/><actuator name="m" role="a"/>'
    block = f'<transmission name="t">{inside}</transmission>'
    assert reported("RCT017", ROBOT + control(driven("swing"), block.format("joint1"))) == []
    assert messages("RCT017", ROBOT + control(driven("swing"), block.format(""))) == [
        "<joint> of a transmission has no role"
    ]
