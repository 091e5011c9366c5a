"""JNT038: see the rule."""

import pytest

from tests.reported import fixed, messages

ROBOT = """\
<link name="a"><visual><geometry><box size="{size} 0.1 0.1"/></geometry></visual></link>
<link name="b"/>
<joint name="j" type="prismatic"><parent link="a"/><child link="b"/>
<limit lower="{lower}" upper="{upper}" effort="1" velocity="1"/></joint>"""


def robot(lower: str, upper: str, size: str = "0.1") -> str:
    return ROBOT.format(lower=lower, upper=upper, size=size)


def test_thirty_metres_of_a_gripper() -> None:
    assert messages("JNT038", robot("0", "30")) == [
        "joint 'j' may slide from 0 to 30 m, and no part of the robot is longer than 0.1 m"
    ]
    mended = fixed("JNT038", robot("-5", "30"))
    assert 'lower="-0.005" upper="0.03"' in mended


@pytest.mark.parametrize(
    ("lower", "upper", "size"),
    [
        ("0", "0.03", "0.1"),
        ("0", "30", "2"),  # a gantry
        ("0", "30.5", "0.1"),  # nobody measures half millimetres
        ("-1000000", "1000000", "0.1"),  # free
    ],
)
def test_what_may_be_meant_is_calm(lower: str, upper: str, size: str) -> None:
    assert messages("JNT038", robot(lower, upper, size)) == []
