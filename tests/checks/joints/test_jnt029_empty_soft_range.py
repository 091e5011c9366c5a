from __future__ import annotations

import pytest

from tests.jointed import joint, limit, robot
from tests.reported import messages, places, reported

BOTH = 'soft_lower_limit="{}" soft_upper_limit="{}"'


def safe(name: str, soft: str, kind: str = "revolute", hard: tuple[str, str] = ("-1", "2")) -> str:
    return joint(name, kind, limit(*hard) + f'<safety_controller {soft} k_velocity="1"/>')


@pytest.mark.parametrize(
    ("soft", "shown"),
    [
        ("", "0 to 0 rad (not written: soft_lower_limit, soft_upper_limit)"),
        ('soft_upper_limit="-0.5"', "0 to -0.5 rad (not written: soft_lower_limit)"),
        (BOTH.format("0", "0"), "0 to 0 rad"),
        (BOTH.format("1.9", "-0.9"), "1.9 to -0.9 rad"),
        (BOTH.format("3", "4"), "3 to 4 rad"),
        (BOTH.format("-4", "-1"), "-4 to -1 rad"),
    ],
)
def test_no_room(soft: str, shown: str) -> None:
    text = robot(safe("j", soft))
    assert messages("JNT029", text) == [
        f"joint 'j': the soft limits {shown} leave no room within the limits"
    ]
    assert places("JNT029", text) == [(4, f'<safety_controller {soft} k_velocity="1"/>')]


def test_all_joints_are_one_finding() -> None:
    text = robot(*(safe(name, "", "prismatic") for name in "abc"))
    (found,) = reported("JNT029", text)
    assert found.message == (
        "joints 'a', 'b' and 1 more: the soft limits 0 to 0 m (not written: soft_lower_limit, "
        "soft_upper_limit) leave no room within the limits"
    )
    assert [other.span.line for other in found.related] == [6, 8]


@pytest.mark.parametrize(
    "joints",
    [
        safe("j", BOTH.format("-0.9", "1.9")),
        safe("j", 'soft_lower_limit="-0.9"'),
        safe("j", BOTH.format("-9", "9")),  # JNT019
        safe("j", BOTH.format("x", "1")),  # URD005
        safe("j", "", "continuous"),
        safe("j", "", hard=("0", "0")),  # JNT004
        joint("j", "revolute", limit("-1", "2")),
    ],
)
def test_no_finding(joints: str) -> None:
    assert reported("JNT029", robot(joints)) == []
