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
