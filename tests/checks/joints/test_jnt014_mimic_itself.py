from __future__ import annotations

from tests.jointed import joint, mimic, robot
from tests.reported import messages, places, reported


def test_a_joint_that_mimics_itself() -> None:
    text = robot(joint("j", "continuous", mimic("j")))
    assert messages("JNT014", text) == ["joint 'j' mimics itself"]
    assert places("JNT014", text) == [(4, "j")]


def test_no_finding() -> None:
    others = [
        joint("j", "continuous", mimic("k")),
        joint("j", "continuous", "<mimic/>"),
        joint("", "continuous", mimic("")),
    ]
    for other in others:
        assert reported("JNT014", robot(other, joint("k", "continuous"))) == []
