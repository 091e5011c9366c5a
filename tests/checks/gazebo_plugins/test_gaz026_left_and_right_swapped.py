from __future__ import annotations

import pytest

from tests.gazebos import BASE, WHEELS, plugin, wheel
from tests.reported import messages, reported

DRIVE = "libgazebo_ros_diff_drive.so"


def drive(robot: str = WHEELS, left: str = "left", right: str = "right", more: str = "") -> str:
    tags = f"<leftJoint>{left}_joint</leftJoint><rightJoint>{right}_joint</rightJoint>"
    return robot + plugin(DRIVE, tags + more)


def wheels(left: str, right: str) -> str:
    return BASE + wheel("left", 0.15, axis=left) + wheel("right", -0.15, axis=right)


def test_interchanged() -> None:
    (message,) = messages("GAZ026", drive(left="right", right="left"))
    assert message == (
        f"plugin 'p' ({DRIVE}): the left joint 'right_joint' is 0.3 m to the right of "
        "'left_joint' as the robot rolls, so that it turns the wrong way"
    )


def test_both_axes_turned_reverse_the_robot() -> None:
    assert len(reported("GAZ026", drive(wheels("0 -1 0", "0 -1 0")))) == 1
    backwards = drive(wheels("0 -1 0", "0 -1 0"), "right", "left")
    assert reported("GAZ026", backwards) == [], "it drives along -x, and left is left of that"


def test_axes_against_each_other() -> None:
    (message,) = messages("GAZ026", drive(wheels("0 1 0", "0 -1 0")))
    assert message == (
        f"plugin 'p' ({DRIVE}): the axes of 'left_joint' and 'right_joint' point in opposite "
        "directions, so that going straight turns the robot"
    )


@pytest.mark.parametrize(
    "text",
    [
        drive(),
        drive(wheels("1 0 0", "0 1 0")),  # no axle
        drive(wheels("0 0 1", "0 0 1")),  # nothing to the left along z
        drive(left="right", right="left", more="<legacyMode>true</legacyMode>"),
        WHEELS + plugin("libvendor.so", "<leftJoint>right_joint</leftJoint>"),
    ],
)
def test_no_finding(text: str) -> None:
    assert reported("GAZ026", text) == []
