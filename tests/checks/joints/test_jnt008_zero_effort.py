from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported

ZERO = limit("-1", "1", effort="0")
GOOD = limit("-1", "1", effort="5")


@pytest.mark.parametrize(
    ("kind", "unit"), [("revolute", "N m"), ("continuous", "N m"), ("prismatic", "N")]
)
def test_one_joint(kind: str, unit: str) -> None:
    text = robot(joint("a", kind, ZERO), joint("b", "revolute", GOOD))
    assert messages("JNT008", text) == [f"joint 'a': the effort limit is 0 {unit}"]
    assert places("JNT008", text) == [(4, "0")]


def test_all_joints_of_a_robot_are_one_finding() -> None:
    text = robot(*(joint(name, "revolute", ZERO) for name in "abcd"))
    (found,) = reported("JNT008", text)
    assert found.message == "joints 'a', 'b' and 2 more: the effort limit is 0 N m"
    assert [(other.span.line, other.message) for other in found.related] == [
        (6, "joint 'b'"),
        (8, "joint 'c'"),
        (10, "joint 'd'"),
    ]


def test_the_joints_of_a_large_robot_are_not_all_listed() -> None:
    text = robot(*(joint(f"j{number}", "revolute", ZERO) for number in range(60)))
    (found,) = reported("JNT008", text)
    assert found.message == "joints 'j0', 'j1' and 58 more: the effort limit is 0 N m"
    assert len(found.related) == 20


def test_a_macro_is_one_place() -> None:
    macro = joint("${name}", "revolute", ZERO)
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        f'<xacro:macro name="arm" params="name">{macro}</xacro:macro>'
        '<xacro:arm name="a"/><xacro:arm name="b"/></robot>'
    )
    (found,) = reported("JNT008", text, "robot.xacro")
    assert found.message == "joints 'a' and 'b': the effort limit is 0 N m"
    assert found.related == ()


@pytest.mark.parametrize("ends", [("0", "0"), ("0.3", "0.3")])
def test_a_joint_that_cannot_move_needs_none(ends: tuple[str, str]) -> None:
    text = robot(joint("a", "revolute", limit(*ends, effort="0")))
    assert messages("JNT008", text) == []
    assert len(messages("JNT004", text)) == 1
