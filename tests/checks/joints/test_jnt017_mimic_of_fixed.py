from __future__ import annotations

import pytest

from tests.jointed import joint, mimic, robot
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source


@pytest.mark.parametrize("kind", ["fixed", "floating", "planar"])
def test_a_leader_without_a_position(kind: str) -> None:
    text = robot(joint("a", kind), joint("b", "continuous", mimic("a")))
    assert messages("JNT017", text) == [f"joint 'b': <mimic> of 'a', which is {kind}"]
    assert places("JNT017", text) == [(6, mimic("a"))]


def test_all_followers_of_a_leader_are_one_finding() -> None:
    followers = [joint(name, "continuous", mimic("a")) for name in "bcd"]
    text = robot(joint("a", "fixed"), *followers)
    assert messages("JNT017", text) == [
        "joints 'b', 'c' and 1 more: <mimic> of 'a', which is fixed"
    ]


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "screw"])
def test_no_finding(kind: str) -> None:
    assert reported("JNT017", robot(joint("a", kind), joint("b", "continuous", mimic("a")))) == []


def test_other_rules_tell_unknown_leaders_and_joints_that_mimic_themselves() -> None:
    assert reported("JNT017", robot(joint("a", "fixed", mimic("a")))) == []
    assert reported("JNT017", robot(joint("a", "continuous", mimic("z")))) == []


def test_drake_refuses_a_fixed_joint_that_follows() -> None:
    text = robot(joint("a", "continuous"), joint("b", "fixed", mimic("a")))
    assert reported("JNT017", text) == []
    source = Source("robot.urdf", whole_robot(text).encode())
    report = engine.check(source, select=["JNT017"], targets=["drake"])
    assert [(found.severity, found.message) for found in report.diagnostics] == [
        (Severity.ERROR, "joint 'b': <mimic> on a fixed joint")
    ]
