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


#: A finger of three joints that bend from zero, as SCHUNK's SVH has four of them.
BENDING = """\
<link name="{0}_1"/><link name="{0}_2"/><link name="{0}_3"/>
<joint name="{0}_{1}" type="revolute"><parent link="palm"/><child link="{0}_1"/>
<origin xyz="0 0 0" rpy="{2} 0 0"/><axis xyz="0 0 1"/><limit upper="0.8" effort="1" velocity="1"/>
</joint>
<joint name="{0}_b" type="revolute"><parent link="{0}_1"/><child link="{0}_2"/>
<axis xyz="0 0 1"/><limit upper="1.3" effort="1" velocity="1"/></joint>
<joint name="{0}_c" type="revolute"><parent link="{0}_2"/><child link="{0}_3"/>
<axis xyz="0 0 1"/><limit upper="1.4" effort="1" velocity="1"/></joint>
"""


def bending(fingers: tuple[str, ...] = FINGERS, over: tuple[str, ...] = ()) -> str:
    """A hand; the fingers have other names of their first joints, so that these tell nothing."""
    return '<link name="palm"/>\n' + "".join(
        BENDING.format(finger, "a" * number, "3.1415926536" if finger in over else "0")
        for number, finger in enumerate(fingers, start=1)
    )


def test_one_joint_that_bends_the_other_way() -> None:
    assert messages("JNT025", bending()) == []
    before, name, rest = bending(FINGERS[:3]).partition('name="middle_b"')
    text = before + name + rest.replace("0 0 1", "0 0 -1", 1)
    assert messages("JNT025", text) == [naming("middle_b", "middle_aa", "2")]
    assert [at for _, at in places("JNT025", text)] == ['<axis xyz="0 0 -1"/>']


def test_joints_that_may_bend_the_other_way() -> None:
    """One of two fingers; joints that bend to both sides, as those of an arm."""
    before, name, rest = bending(FINGERS[:2]).partition('name="middle_b"')
    assert messages("JNT025", before + name + rest.replace("0 0 1", "0 0 -1", 1)) == []
    before, name, rest = bending(FINGERS[:3]).partition('name="middle_b"')
    both = before + name + rest.replace("0 0 1", "0 0 -1", 1)
    assert messages("JNT025", both.replace('upper="1.3"', 'lower="-1.3" upper="1.3"')) == []


def test_inverted_limits_do_not_bend() -> None:
    text = bending(FINGERS[:3]).replace('upper="0.8"', 'upper="-0.8"', 1)
    assert messages("JNT025", text) == []


@pytest.mark.parametrize(
    ("fingers", "over", "found"),
    [
        (FINGERS, ("ring",), ["ring_aaa"]),
        (FINGERS, ("ring", "pinky"), []),
        (FINGERS[:3], ("ring",), []),
        ((*FINGERS[:3], "thumb"), ("thumb",), []),  # opposite the fingers
    ],
)
def test_one_finger_that_bends_the_other_way(
    fingers: tuple[str, ...], over: tuple[str, ...], found: list[str]
) -> None:
    heard = messages("JNT025", bending(fingers, over))
    assert [one.split("'")[1] for one in heard] == found
