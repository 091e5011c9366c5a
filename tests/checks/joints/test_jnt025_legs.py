"""One leg of four that differs from its counterpart."""

import pytest

from tests.naming import naming
from tests.reported import messages

#: A leg of the Mini Pupper: hip, knee and foot, with a mesh for each side.
LEG = """\
<joint name="base_{0}1" type="revolute"><parent link="base"/><child link="{0}1"/>
<origin xyz="{1} {2}0.02 0"/><axis xyz="1 0 0"/><limit {3} effort="20" velocity="1"/></joint>
<joint name="{0}1_{0}2" type="revolute"><parent link="{0}1"/><child link="{0}2"/>
<origin xyz="0 {2}0.005 -0.05"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="-0.2" effort="20" velocity="1"/></joint>
<joint name="{0}2_foot" type="fixed"><parent link="{0}2"/><child link="{0}foot"/>
<origin xyz="0 0 -0.056"/></joint>
<link name="{0}1"/><link name="{0}2"><visual><geometry><mesh filename="{0}2.stl"/></geometry>
</visual></link><link name="{0}foot"/>
"""
OUTWARDS = {"": 'lower="-0.5" upper="0.4"', "-": 'lower="-0.4" upper="0.5"'}


def quadruped() -> str:
    legs = {"lf": ("0.1", ""), "rf": ("0.1", "-"), "rb": ("-0.1", "-"), "lb": ("-0.1", "")}
    return '<link name="base"/>' + "".join(
        LEG.format(leg, x, side, OUTWARDS[side]) for leg, (x, side) in legs.items()
    )


@pytest.mark.parametrize(
    ("after", "old", "new", "expected"),
    [
        (
            "base_rb1",
            OUTWARDS["-"],
            OUTWARDS[""],
            naming("base_rb1", "base_lb1", "[-0.4, 0.5] rad"),
        ),
        ("rb1_rb2", "0 -0.005 ", "0 0.005 ", naming("rb1_rb2", "0.01 m", "left", "lb1_lb2")),
        ("rf1_rf2", 'effort="20"', 'effort="2"', naming("rf1_rf2", "lf1_lf2", "2", "20 N·m")),
        ("rf1_rf2", "0 1 0", "0 -1 0", naming("rf1_rf2", "lf1_lf2", "[0.2, 2] rad")),
        ("lb2_foot", "-0.056", "-0.065", naming("lb2_foot", "0.009 m", "down", "rb2_foot")),
        ("lb1_lb2", 'link="lb1"', 'link="lf1"', naming("lb1_lb2", "lf1", "rb1_rb2", "rb1")),
    ],
)
def test_one_leg_of_four(after: str, old: str, new: str, expected: str) -> None:
    """Mangdang's Mini Pupper: each joint has the side twice in its name."""
    assert messages("JNT025", quadruped()) == []
    before, name, leg = quadruped().partition(f'name="{after}"')
    assert messages("JNT025", before + name + leg.replace(old, new, 1)) == [expected] * bool(
        expected
    )


def test_legs_of_which_one_is_turned() -> None:
    """PAL's Kangaroo: the same origin in shoulders of which one is turned by half a turn."""
    assert messages("JNT025", quadruped()) == []
    text = quadruped().replace('xyz="-0.1 -0.02 0"', 'xyz="-0.1 -0.02 0" rpy="3.14159 0 3.14159"')
    before, name, leg = text.partition('name="rb1_rb2"')
    turned = before + name + leg.replace("0 -0.005 -0.05", "0.01 0.005 -0.05", 1)
    before, name, leg = turned.partition('name="lb1_lb2"')
    turned = before + name + leg.replace("0 0.005 -0.05", "0.01 0.005 -0.05", 1)
    assert not any("rb1_rb2" in message for message in messages("JNT025", turned))


def test_two_cameras_of_one_product() -> None:
    """Galaxea's R1: the lens of each is beside its middle, to the same side."""
    text = quadruped()
    for side in ("lf", "rf"):
        text += (
            f'<joint name="{side}2_camera" type="fixed"><parent link="{side}2"/>'
            f'<child link="{side}_camera"/><origin xyz="0 0.0042 0"/></joint>'
            f'<link name="{side}_camera"><visual><geometry><mesh filename="{side}_camera.stl"/>'
            "</geometry></visual></link>"
        )
    assert messages("JNT025", text) == []


#: A leg whose hip and knee turn about y, in a frame that two legs may have turned over.
SIMPLE = """\
<link name="hip_{0}"/><link name="knee_{0}"/>
<joint name="hip_{0}_joint" type="revolute"><parent link="base"/><child link="hip_{0}"/>
<origin xyz="{1} {2} 0" rpy="0 0 {3}"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="9" velocity="9"/></joint>
<joint name="knee_{0}_joint" type="revolute"><parent link="hip_{0}"/><child link="knee_{0}"/>
<origin xyz="0 0 -0.2"/><axis xyz="0 1 0"/>
<limit lower="-2" upper="2" effort="9" velocity="9"/></joint>
"""


def simple(turned: tuple[str, ...] = ()) -> str:
    legs = {"FL": (0.2, 0.067), "FR": (0.2, -0.067), "RL": (-0.2, 0.067), "RR": (-0.2, -0.067)}
    return '<link name="base"/>' + "".join(
        SIMPLE.format(leg, *place, 3.1415926536 if leg in turned else 0)
        for leg, place in legs.items()
    )


def with_axis(text: str, joint: str, axis: str = "0 -1 0") -> str:
    before, name, rest = text.partition(f'<joint name="{joint}"')
    return before + name + rest.replace('"0 1 0"', f'"{axis}"', 1)


@pytest.mark.parametrize("turned", [(), ("FL", "RL"), ("FL", "FR"), ("RL", "RR")])
@pytest.mark.parametrize("leg", ["FL", "FR", "RL", "RR"])
def test_one_knee_that_turns_the_other_way(leg: str, turned: tuple[str, ...]) -> None:
    """Also if two legs are mounted the other way round: the hips show which knee it is."""
    text = simple(turned)
    assert messages("JNT025", text) == []
    axis = "0 1 0" if leg in turned else "0 -1 0"
    wrong = with_axis(text, f"knee_{leg}_joint")
    assert messages("JNT025", wrong) == [naming(f"knee_{leg}_joint", axis, "3")]


def test_knees_that_may_turn_the_other_way() -> None:
    """Two of them; one with mirrored limits; wheels."""
    two = with_axis(with_axis(simple(), "knee_FL_joint"), "knee_RL_joint")
    assert messages("JNT025", two) == []
    one_sided = simple().replace('lower="-2" upper="2"', 'lower="-2" upper="0.2"')
    before, name, rest = with_axis(one_sided, "knee_FL_joint").partition('"knee_FL_joint"')
    mirrored = rest.replace('lower="-2" upper="0.2"', 'lower="-0.2" upper="2"', 1)
    assert not any("root frame" in one for one in messages("JNT025", before + name + mirrored))
    wheels = with_axis(simple(), "hip_RR_joint").replace("revolute", "continuous")
    assert messages("JNT025", wheels) == []


@pytest.mark.parametrize(
    ("old", "new", "expected"),
    [
        ("0.2 -0.067 0", "0.2 -0.076 0", [naming("hip_FR_joint", "-0.076 m", "0.067 m")]),
        ("0.2 -0.067 0", "0.2 -0.0675 0", []),  # not quite symmetric
        ("0.2 -0.067 0", "0.21 -0.068 0", []),  # two numbers
    ],
)
def test_one_number_of_one_origin(old: str, new: str, expected: list[str]) -> None:
    text = simple().replace(f'"{old}"', f'"{new}"')
    assert [one for one in messages("JNT025", text) if "all other legs" in one] == expected


def test_joints_of_one_arm_are_no_legs() -> None:
    text = '<link name="j_left_0"/>'
    for number in range(1, 7):
        text += (
            f'<link name="j_left_{number}"/><joint name="a_left_{number}" type="revolute">'
            f'<parent link="j_left_{number - 1}"/><child link="j_left_{number}"/>'
            f'<origin xyz="0 0 {0.3 if number == 2 else 0.1}"/>'
            f'<axis xyz="0 {-1 if number == 3 else 1} 0"/>'
            '<limit lower="-2" upper="2" effort="9" velocity="9"/></joint>'
        )
    assert messages("JNT025", text) == []
