import pytest

from tests.jointed import joint, robot
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "damping", "friction"),
    [
        ("revolute", "N·m·s/rad", "N·m"),
        ("continuous", "N·m·s/rad", "N·m"),
        ("prismatic", "N·s/m", "N"),
    ],
)
def test_a_negative_amount(kind: str, damping: str, friction: str) -> None:
    text = robot(joint("j", kind, '<dynamics damping="-0.5" friction="-2e-3"/>'))
    assert messages("JNT008", text) == [
        f"joint 'j': the damping is -0.5 {damping}, below 0",
        f"joint 'j': the friction is -0.002 {friction}, below 0",
    ]
    assert places("JNT008", text) == [(4, "-0.5"), (4, "-2e-3")]


@pytest.mark.parametrize(
    "content",
    ["", '<dynamics damping="0" friction="-0"/>', '<dynamics damping="-x"/>', "<dynamics/>"],
)
def test_no_finding(content: str) -> None:
    assert reported("JNT008", robot(joint("j", "continuous", content))) == []
