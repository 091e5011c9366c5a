"""JNT034: see the rule."""

import pytest

from tests.checks.joints.test_jnt033_wheel_axis_across import robot
from tests.reported import messages, places


def test_a_wheel_that_stops() -> None:
    text = robot(kind="revolute")
    assert messages("JNT034", text) == ["joint 'j' of wheel 'wheel' is revolute, from -1 to 1 rad"]
    assert [at for _, at in places("JNT034", text)] == ["revolute"]


@pytest.mark.parametrize(
    "sound",
    [
        robot(),
        robot("0 0 1", kind="revolute"),  # it is steered
        robot(kind="revolute", name="arm"),
        robot(kind="revolute").replace('lower="-1" upper="1"', 'lower="-1e3" upper="1e3"'),
    ],
)
def test_what_rolls_on_is_calm(sound: str) -> None:
    assert messages("JNT034", sound) == []
