"""JNT016: fingers of a gripper that mimic each other."""

import pytest

from tests.naming import naming
from tests.reported import messages

FINGER = """\
<link name="{side}"/><joint name="{side}_joint" type="{kind}"><parent link="palm"/>
<child link="{side}"/><origin xyz="0 {y} 0"/><axis xyz="{axis}"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/>{mimic}</joint>
"""


def robot(axis: str, multiplier: str = "1", kind: str = "prismatic") -> str:
    mimic = f'<mimic joint="left_joint" multiplier="{multiplier}"/>'
    left = FINGER.format(side="left", y=0.01, axis="0 1 0", mimic="", kind=kind)
    right = FINGER.format(side="right", y=-0.01, axis=axis, mimic=mimic, kind=kind)
    return f'<link name="palm"/>{left}{right}'


@pytest.mark.parametrize(("axis", "multiplier"), [("0 1 0", "1"), ("0 -1 0", "-1")])
def test_they_never_come_closer(axis: str, multiplier: str) -> None:
    assert messages("JNT016", robot(axis, multiplier)) == [naming("right_joint", "left_joint")]


def at_one_place(rpy: str, multiplier: str, names: str = "finger") -> str:
    text = robot("0 1 0", multiplier).replace('xyz="0 -0.01 0"', f'xyz="0 0.01 0" rpy="{rpy}"')
    for side in ("left", "right"):
        text = text.replace(f'link="{side}"', f'link="{side}_{names}"')
        text = text.replace(f'<link name="{side}"', f'<link name="{side}_{names}"')
    return text


@pytest.mark.parametrize(
    ("rpy", "multiplier", "count"),
    [("0 0 0", "1", 1), ("0 0 0", "-1", 0), ("0 0 3.14159", "1", 0), ("0 0 3.14159", "-1", 1)],
)
def test_fingers_of_which_one_is_turned(rpy: str, multiplier: str, count: int) -> None:
    """Franka's hand: both fingers have the same origin, and the right one half a turn."""
    assert len(messages("JNT016", at_one_place(rpy, multiplier))) == count
    assert messages("JNT016", at_one_place(rpy, multiplier, "rail")) == []
    numbered = at_one_place(rpy, multiplier, "jaw")
    numbered = numbered.replace("left_jaw", "jaw1").replace("right_jaw", "jaw2")
    assert len(messages("JNT016", numbered)) == count, "AR4's gripper"


@pytest.mark.parametrize(
    ("axis", "multiplier", "kind"),
    [
        ("0 -1 0", "1", "prismatic"),
        ("0 1 0", "-1", "prismatic"),
        ("1 0 0", "1", "prismatic"),  # a lift on two rails
        ("0 1 0", "0.5", "prismatic"),  # a torso that rises half as far as the arm, as HSR's
        ("0 1 0", "1", "revolute"),
    ],
)
def test_what_closes_or_is_no_gripper_is_calm(axis: str, multiplier: str, kind: str) -> None:
    assert messages("JNT016", robot(axis, multiplier, kind)) == []
