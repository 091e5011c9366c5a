"""JNT031: see the rule."""

import pytest

from tests.told import messages

PART = """\
<link name="{side}"/><joint name="{side}_joint" type="continuous"><parent link="base"/>
<child link="{side}"/><origin xyz="{xyz}" rpy="{rpy}"/><axis xyz="0 1 0"/></joint>
"""


def robot(left: str, right: str, rpy: str = "0 0 0") -> str:
    one = PART.format(side="left", xyz=left, rpy="0 0 0")
    return f'<link name="base"/>{one}{PART.format(side="right", xyz=right, rpy=rpy)}'


@pytest.mark.parametrize(
    ("right", "reason"),
    [
        ("0.1 0.2 -0.05", "is at the place of"),
        ("-0.1 -0.2 -0.05", "is on the other side in y and in x, too, of"),
        ("0.1 -0.2 0.05", "is on the other side in y and in z, too, of"),
    ],
)
def test_a_slip_of_a_sign(right: str, reason: str) -> None:
    assert messages("JNT031", robot("0.1 0.2 -0.05", right)) == [
        f"joint 'right_joint' at {right} m {reason} its twin 'left_joint' at 0.1 0.2 -0.05 m"
    ]


@pytest.mark.parametrize(
    ("left", "right", "rpy"),
    [
        ("0.1 0.2 0", "0.1 -0.2 0", "0 0 0"),
        ("0.1 0.2 0", "0.13 -0.2 0", "0 0 0"),  # robots are not quite symmetric
        ("0.1 0 0", "0.1 0 0", "0 0 0"),  # two axes of one neck
        ("0.1 0.2 0", "-0.1 -0.2 0", "0 0 3.14159"),  # turned about z
    ],
)
def test_what_may_be_meant_is_calm(left: str, right: str, rpy: str) -> None:
    assert messages("JNT031", robot(left, right, rpy)) == []


def test_cameras_that_do_not_move() -> None:
    fixed = robot("0.1 0.2 0", "0.1 0.2 0").replace("continuous", "fixed")
    assert messages("JNT031", fixed) == [
        "joint 'right_joint' at 0.1 0.2 0 m is at the place of its twin 'left_joint' at 0.1 0.2 0 m"
    ]
