"""RCT024: see the rule."""

import pytest

from tests.controls import ROBOT, transmission
from tests.told import fixed, messages, told

SOUND = ROBOT + transmission("swing")


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        (
            "SimpleTransmission",
            "SimpelTransmission",
            (
                "transmission 't': type 'transmission_interface/SimpelTransmission' is nearly "
                "'transmission_interface/SimpleTransmission'"
            ),
        ),
        (">1<", ">0<", "transmission 't': the ratio is 0, and must be a number other than 0"),
        (">1<", ">1:50<", "transmission 't': the ratio is 1:50, and must be a number other than 0"),
        (
            "mechanicalReduction",
            "mechanicalReducton",
            (
                "transmission 't': <actuator> has no <mechanicalReducton>; did you mean "
                "'mechanicalReduction'?"
            ),
        ),
    ],
)
def test_what_is_refused(old: str, new: str, message: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == [message]


def test_slips_are_mended() -> None:
    assert fixed("RCT024", SOUND.replace("SimpleT", "SimpelT")) == fixed("RCT024", SOUND)


@pytest.mark.parametrize(
    ("old", "new"), [(">1<", ">-50.5<"), ("Simple", "HalfDifferential"), ("Simple", "Differential")]
)
def test_what_is_read_or_of_others(old: str, new: str) -> None:
    assert messages("RCT024", SOUND.replace(old, new)) == []


def test_ros2_passes_over_it_whatever_it_says() -> None:
    assert told("RCT024", SOUND.replace(">1<", ">0<"), targets=("ros2",)) == []
