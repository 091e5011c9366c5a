from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported

ZERO = limit("-1", "1", velocity="0")
GOOD = limit("-1", "1", velocity="5")


@pytest.mark.parametrize(
    ("kind", "unit"), [("revolute", "rad/s"), ("continuous", "rad/s"), ("prismatic", "m/s")]
)
def test_one_joint(kind: str, unit: str) -> None:
    text = robot(joint("a", kind, ZERO), joint("b", "revolute", GOOD))
    assert messages("JNT009", text) == [f"joint 'a': the velocity limit is 0 {unit}"]
    assert places("JNT009", text) == [(4, "0")]


def test_several_joints_are_one_finding() -> None:
    (found,) = reported("JNT009", robot(*(joint(name, "revolute", ZERO) for name in "abc")))
    assert found.message == "joints 'a', 'b' and 1 more: the velocity limit is 0 rad/s"
    assert [other.message for other in found.related] == ["joint 'b'", "joint 'c'"]


@pytest.mark.parametrize("ends", [("0", "0"), ("0.3", "0.3")])
def test_a_joint_that_cannot_move_needs_none(ends: tuple[str, str]) -> None:
    text = robot(joint("a", "revolute", limit(*ends, velocity="0")))
    assert messages("JNT009", text) == []
    assert len(messages("JNT004", text)) == 1
