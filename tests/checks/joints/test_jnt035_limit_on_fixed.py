"""JNT035: see the rule."""

from tests.jointed import joint, limit, robot
from tests.reported import messages


def test_a_range_that_nothing_uses() -> None:
    assert messages("JNT035", robot(joint("j", "fixed", limit("-1", "1", "1", "1")))) == [
        "joint 'j' is fixed, and its limits are -1 to 1"
    ]


def test_zeros_of_an_exporter_and_joints_that_move_are_calm() -> None:
    assert messages("JNT035", robot(joint("j", "fixed", limit("0", "0", "0", "0")))) == []
    assert messages("JNT035", robot(joint("j", "revolute", limit("-1", "1", "1", "1")))) == []
    assert messages("JNT035", robot(joint("j", "fixed"))) == []
