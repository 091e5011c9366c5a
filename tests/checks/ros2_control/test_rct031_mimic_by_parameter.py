"""RCT031: see the rule."""

import pytest

from tests.controls import CLASSIC, GZ, MOCK, ROBOT, control, driven
from tests.reported import messages, reported

FOLLOWS = '<param name="mimic">swing</param><param name="multiplier">1</param>'


def test_a_parameter_of_humble_for_jazzy() -> None:
    text = ROBOT + control(driven("slide", more=FOLLOWS), plugin=GZ)
    assert messages("RCT031", text) == [
        (
            "joint 'slide' follows 'swing' by a parameter, which ros2_control does not read from "
            "Jazzy on"
        )
    ]


@pytest.mark.parametrize(
    ("joint", "hardware"),
    [("slide", CLASSIC), ("slide", "ign_ros2_control/IgnitionSystem"), ("slide", MOCK)],
)
def test_where_it_is_read_or_nothing_is_known(joint: str, hardware: str) -> None:
    assert reported("RCT031", ROBOT + control(driven(joint, more=FOLLOWS), plugin=hardware)) == []


def test_a_joint_that_mimics_needs_no_parameter() -> None:
    assert reported("RCT031", ROBOT + control(driven("follow", more=FOLLOWS), plugin=GZ)) == []
    assert reported("RCT031", ROBOT + control(driven("slide"), plugin=GZ)) == []
