from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "effort", "velocity"),
    [
        ("revolute", "N m", "rad/s"),
        ("continuous", "N m", "rad/s"),
        ("prismatic", "N", "m/s"),
    ],
)
def test_a_negative_limit(kind: str, effort: str, velocity: str) -> None:
    text = robot(joint("j", kind, limit("-1", "1", "-2", "-0.5")))
    assert messages("JNT028", text) == [
        f"joint 'j': the effort limit is -2 {effort}, below 0",
        f"joint 'j': the velocity limit is -0.5 {velocity}, below 0",
    ]
    assert places("JNT028", text) == [(4, "-2"), (4, "-0.5")]


def test_all_joints_are_one_finding() -> None:
    text = robot(*(joint(name, "revolute", limit("-1", "1", "-1")) for name in "abc"))
    (found,) = reported("JNT028", text)
    assert found.message == "joints 'a', 'b' and 1 more: the effort limit is -1 N m, below 0"
    assert [other.span.line for other in found.related] == [6, 8]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("revolute", limit("-1", "1")),
        ("revolute", limit("-1", "1", "0", "-0")),  # JNT008, JNT009
        ("revolute", limit("-1", "1", "-x")),  # URD005
        ("fixed", limit("-1", "1", "-1", "-1")),
        ("continuous", ""),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT028", robot(joint("j", kind, content))) == []
