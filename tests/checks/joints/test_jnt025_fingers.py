"""JNT025: fingers of a hand."""

import pytest

from tests.naming import naming
from tests.reported import messages, places

FINGERS = ("index", "middle", "ring", "pinky")
JOINT = (
    '<link name="{0}_pip"/><joint name="{0}_pip_joint" type="revolute"><parent link="{0}_mcp"/>'
    '<child link="{0}_pip"/><axis xyz="0 0 -1"/>'
    '<limit lower="-1.6" upper="0.2" effort="1.6" velocity="7"/></joint>\n'
)


def hand(old: str, new: str, *changed: str, fingers: tuple[str, ...] = FINGERS) -> str:
    """A hand in which something is different in some fingers."""
    text = '<link name="palm"/>\n'
    for finger in fingers:
        text += f'<link name="{finger}_mcp"/><joint name="{finger}_mcp_joint" type="fixed">'
        text += f'<parent link="palm"/><child link="{finger}_mcp"/></joint>'
        joint = JOINT.format(finger)
        assert finger not in changed or old in joint
        text += joint.replace(old, new) if finger in changed else joint
    return text


@pytest.mark.parametrize(
    ("old", "new", "difference"),
    [
        ("-1.6", "-0.16", "-1.6 rad"),
        ("-1.6", "1.6", "-1.6 rad"),
        ("-1.6", "-91.67", "-1.6 rad"),
        ('effort="1.6"', 'effort="160"', "1.6 N·m"),
        ('velocity="7"', 'velocity="0.07"', "7 rad/s"),
        ("0 0 -1", "0 0 1", "0 0 -1"),
        ("ring_mcp", "index_mcp", "ring_mcp"),
    ],
)
def test_one_finger_that_differs(old: str, new: str, difference: str) -> None:
    text = hand(old, new, "ring")
    (found,) = [one for one in messages("JNT025", text) if "fingers" in one]
    assert found.startswith("joint 'ring_pip_joint' differs")
    assert difference in found
    ((line, at),) = places("JNT025", text)
    assert line == 5
    assert at in new or new in at


@pytest.mark.parametrize(
    ("old", "new", "changed"),
    [
        ("-1.6", "-1.2", ("pinky",)),  # another range
        ('effort="1.6"', 'effort="0.8"', ("pinky",)),  # a weaker motor
        ("-1.6", "-0.16", ("ring", "pinky")),
        (
            '"0 0 -1"/><limit lower="-1.6" upper="0.2"',
            '"0 0 1"/><limit lower="-0.2" upper="1.6"',
            ("ring",),
        ),
    ],
)
def test_fingers_that_may_differ(old: str, new: str, changed: tuple[str, ...]) -> None:
    assert messages("JNT025", hand(old, new, *changed)) == []


def test_three_fingers_tell_nothing() -> None:
    assert messages("JNT025", hand("-1.6", "-0.16", "ring", fingers=FINGERS[:3])) == []


def test_the_mass_of_one_finger() -> None:
    text = ""
    for finger, mass in zip(FINGERS, (0.01, 0.01, 0.1, 0.01), strict=True):
        text += f'<link name="{finger}"><inertial><mass value="{mass}"/><inertia ixx="1e-5" '
        text += 'iyy="1e-5" izz="1e-5" ixy="0" ixz="0" iyz="0"/></inertial></link>\n'
    assert messages("INE012", text) == [naming("ring", "0.1 kg", "0.01 kg")]
    assert places("INE012", text) == [(4, "0.1")]
    assert messages("INE012", text.replace('"0.1"', '"0.03"')) == []
