"""JNT036: see the rule."""

import pytest

from tests.jointed import joint, mimic, robot
from tests.reported import messages


def followed(how: str) -> str:
    follower = joint("f", "continuous", mimic("j").replace("/>", f" {how}/>"))
    return robot(joint("j", "continuous"), follower)


@pytest.mark.parametrize("how", ['multiplier="0"', 'multiplier="0.0"'])
def test_times_nothing(how: str) -> None:
    assert messages("JNT036", followed(how)) == ["joint 'f' follows 'j' times 0: it stays at 0"]


@pytest.mark.parametrize("how", ["", 'multiplier="-1"', 'offset="0"'])
def test_what_follows_is_calm(how: str) -> None:
    assert messages("JNT036", followed(how)) == []
