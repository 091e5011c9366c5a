"""RCT025: see the rule."""

from pathlib import Path

from tests.driving import DRIVE, place, reported
from tests.gazebos import BASE, wheel


def test_the_lists_are_interchanged(tmp_path: Path) -> None:
    swapped = DRIVE.replace("left_joint", "?").replace("right_joint", "left_joint")
    (found,) = reported(tmp_path, "RCT025", swapped.replace("?", "right_joint"))
    assert found.message == (
        "controller 'drive': the left joint 'right_joint' is 0.3 m to the right of 'left_joint' "
        "as the robot rolls, so that it turns the wrong way"
    )
    assert place(found) == ("c.yaml", 7, "right_joint")


def test_axes_that_point_at_each_other(tmp_path: Path) -> None:
    robot = BASE + wheel("left", 0.15) + wheel("right", -0.15, axis="0 -1 0")
    (found,) = reported(tmp_path, "RCT025", DRIVE, robot)
    assert "point in opposite directions" in found.message


def test_sound_wheels_are_calm(tmp_path: Path) -> None:
    assert reported(tmp_path, "RCT025", DRIVE) == []
    unknown = DRIVE.replace("[left_joint]", "[elsewhere]")
    assert reported(tmp_path, "RCT025", unknown) == []
    one_behind_the_other = BASE + wheel("left", 0.15, axis="1 0 0") + wheel("right", -0.15)
    assert reported(tmp_path, "RCT025", DRIVE, one_behind_the_other) == []
