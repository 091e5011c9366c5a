"""RCT035: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported


@pytest.mark.parametrize(
    "gone", ["left_wheel_names: [left_joint]", "wheel_separation: 0.3", "wheel_radius: 0.1"]
)
def test_a_parameter_that_is_not_there(tmp_path: Path, gone: str) -> None:
    (found,) = reported(tmp_path, "RCT035", DRIVE.replace(f"    {gone}\n", ""))
    assert place(found) == ("c.yaml", 5, "drive")
    assert found.message.endswith(f" lacks {gone.partition(':')[0]}")


def test_parameters_under_a_name_that_is_no_controller(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT035", DRIVE.replace("\ndrive:", "\nbase_controller:"))
    assert place(found) == ("c.yaml", 5, "base_controller")
    assert found.message.endswith("'base_controller' has them, and is no controller")
    assert found.help == "rename it to drive, or the controller"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("wheel_sep", "wheel_sepa"),  # RCT027
        ("drive:\n  ros__parameters:\n    left", "other:\n  ros__parameters:\n    let"),
        ("diff_drive_controller/Diff", "my_drive_controller/Diff"),
    ],
)
def test_what_may_be_elsewhere_is_calm(tmp_path: Path, old: str, new: str) -> None:
    assert reported(tmp_path, "RCT035", DRIVE.replace(old, new)) == []


def test_ros_1_wants_the_names_of_its_wheels(tmp_path: Path) -> None:
    text = "drive:\n  type: diff_drive_controller/DiffDriveController\n  left_wheel: left_joint\n"
    (found,) = reported(tmp_path, "RCT035", text)
    assert place(found) == ("c.yaml", 1, "drive")
    assert found.message.endswith(" lacks right_wheel")
