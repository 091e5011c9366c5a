import pytest

from tests.jointed import joint, robot
from tests.naming import naming
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
        naming("j", "damping", f"-0.5 {damping}", "0"),
        naming("j", "friction", f"-0.002 {friction}", "0"),
    ]
    assert places("JNT008", text) == [(4, "-0.5"), (4, "-2e-3")]


@pytest.mark.parametrize(
    "content",
    ["", '<dynamics damping="0" friction="-0"/>', '<dynamics damping="-x"/>', "<dynamics/>"],
)
def test_no_finding(content: str) -> None:
    assert reported("JNT008", robot(joint("j", "continuous", content))) == []
