import pytest

from tests.jointed import joint, robot
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "does"),
    [
        ("revolute", "turns about"),
        ("continuous", "turns about"),
        ("prismatic", "moves along"),
        ("planar", "moves in the plane across"),
    ],
)
def test_a_joint_that_moves_without_an_axis(kind: str, does: str) -> None:
    text = robot(joint("j", kind))
    assert messages("JNT007", text) == [f"joint 'j' has no <axis>: it {does} x (1 0 0) by default"]
    assert places("JNT007", text) == [(4, f'<joint name="j" type="{kind}">')]


@pytest.mark.parametrize(
    ("kind", "content"),
    [
        ("continuous", '<axis xyz="1 0 0"/>'),
        ("continuous", "<axis/>"),  # JNT006
        ("fixed", ""),
        ("floating", ""),
    ],
)
def test_no_finding(kind: str, content: str) -> None:
    assert reported("JNT007", robot(joint("j", kind, content))) == []
