"""RCT033: see the rule."""

from tests.controls import NEXT, ROBOT, control, driven
from tests.reported import messages, places, reported

MUTE = '<joint name="swing"><command_interface name="velocity"/></joint>'


def test_a_joint_that_tells_nothing() -> None:
    text = ROBOT + control(driven("slide"), MUTE)
    assert messages("RCT033", text) == [
        "joint 'swing' has command interfaces and no state interface"
    ]
    assert places("RCT033", text) == [(NEXT + 3, '<joint name="swing">')]


def test_a_sensor_may_tell_for_it() -> None:
    sensor = '<joint name="swing"><state_interface name="position"/></joint>'
    text = ROBOT + control(MUTE) + control(sensor, name="s", kind="sensor")
    assert reported("RCT033", text) == []


def test_a_joint_without_commands_is_calm() -> None:
    assert reported("RCT033", ROBOT + control('<joint name="swing"/>')) == []
