from __future__ import annotations

from tests.controls import NEXT, ROBOT, transmission
from tests.reported import messages, places, reported

EMPTY = ROBOT + transmission("swing", " ")
PR2 = '<transmission name="t" type="pr2_mechanism_model/SimpleTransmission">{}</transmission>'


def test_without_one() -> None:
    assert messages("RCT003", EMPTY) == [
        "transmission 't': joint 'swing' has no <hardwareInterface>"
    ]
    assert places("RCT003", EMPTY) == [(NEXT + 1, '<joint name="swing">')]
    assert reported("RCT003", ROBOT + transmission("swing")) == []


def test_the_one_in_the_actuator_does_not_count() -> None:
    old = "<hardwareInterface>EffortJointInterface</hardwareInterface></actuator>"
    assert messages("RCT003", EMPTY.replace("</actuator>", old)) == [
        (
            "transmission 't': joint 'swing' has no <hardwareInterface>; "
            "the one in <actuator> does not count"
        )
    ]


def test_who_does_not_read_it() -> None:
    assert reported("RCT003", EMPTY, targets=("ros2",)) == []
    assert reported("RCT003", ROBOT + PR2.format('<joint name="swing"/>')) == []
