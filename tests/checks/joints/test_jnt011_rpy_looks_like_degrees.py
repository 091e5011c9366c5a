from __future__ import annotations

import pytest

from tests.jointed import joint, of_xacro, robot
from tests.reported import fixed, messages, places, reported
from urdfkit.text.diagnostic import Confidence


def turned(rpy: str) -> str:
    return robot(joint("j", "fixed", f'<origin xyz="0 0 0" rpy="{rpy}"/>'))


@pytest.mark.parametrize(
    ("rpy", "worst", "better"),
    [
        ("90 0 0", "90 rad, 14.3", "1.570796327 0 0"),
        ("0 0 -180", "-180 rad, 28.6", "0 0 -3.141592654"),
        ("0 22.5 0", "22.5 rad, 3.6", "0 0.3926990817 0"),
        ("0 7 0", "7 rad, 1.1", "0 0.1221730476 0"),
        ("90 5 -30", "90 rad, 14.3", "1.570796327 0.0872664626 -0.5235987756"),
        ("90 0 1.57", "90 rad, 14.3", "1.570796327 0 1.57"),
        ("360 0 0.0", "360 rad, 57.3", "6.283185307 0 0.0"),
    ],
)
def test_more_than_a_turn_in_whole_degrees(rpy: str, worst: str, better: str) -> None:
    (found,) = reported("JNT011", turned(rpy))
    assert found.message == (f"joint 'j' is turned by {worst} times round; that looks like degrees")
    assert found.confidence is Confidence.INFERRED
    assert places("JNT011", turned(rpy)) == [(4, rpy)]
    assert f'rpy="{better}"' in fixed("JNT011", turned(rpy))


@pytest.mark.parametrize(
    "rpy",
    [
        "0 0 0",
        "1.5708 0 3.14159",
        "0 0 6.283185307179586",
        "0 0 6.2832",
        "-6 5 4",
        "0 0 4.71238898038469",
        "7.853981633974483 0 0",  # 5/2 pi
        "0 0 1000",
        "90 0",  # URD005
        "90 0 x",  # URD005
    ],
)
def test_angles_in_radians(rpy: str) -> None:
    assert reported("JNT011", turned(rpy)) == []


@pytest.mark.parametrize("part", ["visual", "collision", "inertial"])
def test_the_origins_in_links(part: str) -> None:
    text = f'<link name="a"><{part}><origin rpy="0 90 0"/></{part}></link>' + robot(
        joint("j", "fixed")
    )
    assert messages("JNT011", text) == [
        f"link 'a': <{part}> is turned by 90 rad, 14.3 times round; that looks like degrees"
    ]


def test_an_origin_elsewhere_is_not_urdf() -> None:
    text = robot(joint("j", "fixed")) + '<gazebo><origin rpy="0 90 0"/></gazebo>'
    assert reported("JNT011", text) == []


def test_what_an_expression_gave_is_not_edited() -> None:
    text = of_xacro(turned("${90} 0 0"))
    assert [found.fix for found in reported("JNT011", text, "robot.xacro")] == [None]
    assert reported("JNT011", of_xacro(turned("${radians(90)} 0 0")), "robot.xacro") == []


def test_a_robot_of_one_link() -> None:
    shape = '<origin rpy="90 0 0"/><geometry><sphere radius="1"/></geometry>'
    assert messages("JNT011", f'<link name="a"><visual>{shape}</visual></link>') == [
        "link 'a': <visual> is turned by 90 rad, 14.3 times round; that looks like degrees"
    ]
