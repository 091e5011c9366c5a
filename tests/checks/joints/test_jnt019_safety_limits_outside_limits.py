from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported


def safe(name: str, lower: str, upper: str, kind: str = "revolute") -> str:
    safety = f'<safety_controller soft_lower_limit="{lower}" soft_upper_limit="{upper}"/>'
    return joint(name, kind, limit("-1", "2") + safety)


@pytest.mark.parametrize(
    ("lower", "upper"), [("-1.1", "1.9"), ("-0.9", "2.1"), ("-11", "12"), ("-1.001", "2")]
)
def test_soft_limits_beyond_the_limits(lower: str, upper: str) -> None:
    text = robot(safe("j", lower, upper))
    assert messages("JNT019", text) == [
        f"joint 'j': the soft limits {lower} to {upper} rad reach beyond the limits -1 to 2 rad"
    ]
    assert [line for line, _ in places("JNT019", text)] == [4]
    assert places("JNT019", text)[0][1].startswith("<safety_controller")


def test_all_joints_are_one_finding() -> None:
    text = robot(*(safe(name, "-11", "12", "prismatic") for name in "abc"))
    (found,) = reported("JNT019", text)
    assert found.message == (
        "joints 'a', 'b' and 1 more: the soft limits -11 to 12 m reach beyond the limits -1 to 2 m"
    )
    assert [other.span.line for other in found.related] == [6, 8]


@pytest.mark.parametrize(
    "joints",
    [
        safe("j", "-0.9", "1.9"),
        safe("j", "-1", "2"),
        safe("j", "-0.9", "x"),  # URD005
        safe("j", "3", "4"),  # JNT029
        safe("j", "3", "-4"),  # JNT029
        safe("j", "-11", "12", "continuous"),
        joint("j", "revolute", limit("-1", "2")),
    ],
)
def test_no_finding(joints: str) -> None:
    assert reported("JNT019", robot(joints)) == []
