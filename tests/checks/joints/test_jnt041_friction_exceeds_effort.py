"""JNT041: see the rule."""

import pytest

from tests.jointed import joint, limit, mimic, robot
from tests.naming import naming
from tests.reported import messages, places


def arm(dynamics: str, kind: str = "revolute", effort: str = "10", more: str = "") -> str:
    content = f"{limit('-1', '1', effort, '2')}<dynamics {dynamics}/>{more}"
    return robot(joint("j", kind, content))


def test_friction_over_the_effort() -> None:
    assert messages("JNT041", arm('friction="10.5"')) == [
        naming("j", "friction", "10.5 N·m", "effort", "10 N·m")
    ]
    assert places("JNT041", arm('friction="10.5"'))[0][1] == "10.5"
    assert messages("JNT041", arm('friction="10"')) == []  # a gripper of TALOS


def test_damping_that_takes_all_of_the_effort() -> None:
    assert messages("JNT041", arm('damping="1000"')) == [
        naming("j", "damping", "1000 N·m·s/rad", "effort", "10 N·m", "0.01 rad/s", "velocity", "2")
    ]
    assert messages("JNT041", arm('damping="99"')) == []
    assert len(messages("JNT041", arm('damping="1001"', "prismatic"))) == 1
    assert messages("JNT041", arm('damping="999"', "prismatic")) == []


@pytest.mark.parametrize(
    "sound",
    [
        arm('damping="20000"', "prismatic", "10000"),  # the lift of a PR2
        arm('friction="500"', effort="0"),  # JNT008
        arm('friction="500"', "fixed"),
        arm('friction="x" damping="-5"'),
        arm('friction="500"', more=mimic("k")) + joint("k", "continuous"),
    ],
)
def test_what_moves_or_is_reported_elsewhere(sound: str) -> None:
    assert messages("JNT041", sound) == []
