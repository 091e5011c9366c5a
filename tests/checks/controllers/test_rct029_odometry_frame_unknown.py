"""RCT029: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported


def test_a_frame_that_is_no_link(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT029", DRIVE.replace("_id: base", "_id: base_link"))
    assert found.message == (
        "controller 'drive' publishes the transform to 'base_link': the robot has no link "
        "'base_link'; did you mean 'base'?"
    )
    assert place(found) == ("c.yaml", 11, "base_link")


def test_a_frame_that_hangs_on_another(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT029", DRIVE.replace("_id: base", "_id: left"))
    assert found.message.endswith("'left' is a child of 'base'; a frame has one parent")
    assert found.help == "name the root link 'base'"


@pytest.mark.parametrize(
    "more",
    ["", "    enable_odom_tf: false\n", "    tf_frame_prefix: robot\n"],
)
def test_the_root_or_no_transform_is_calm(tmp_path: Path, more: str) -> None:
    text = DRIVE.replace("_id: base", "_id: left") if more else DRIVE
    assert reported(tmp_path, "RCT029", text + more) == []
