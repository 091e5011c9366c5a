"""RCT036: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported

CLASS = "diff_drive_controller/DiffDriveController"


@pytest.mark.parametrize(
    ("kind", "help"),
    [
        ("diff_drive_controller/Drive", f"it has: {CLASS}"),
        (
            "joint_state_controller/JointStateController",
            "take joint_state_broadcaster/JointStateBroadcaster, and see its parameters",
        ),
    ],
)
def test_classes_that_ros_2_does_not_have(tmp_path: Path, kind: str, help: str) -> None:
    (found,) = reported(tmp_path, "RCT036", DRIVE.replace(CLASS, kind))
    assert place(found) == ("c.yaml", 4, kind)
    assert found.help == help


def test_a_class_of_ros_2_in_ros_1(tmp_path: Path) -> None:
    text = "states:\n  type: joint_state_broadcaster/JointStateBroadcaster\n"
    (found,) = reported(tmp_path, "RCT036", text)
    assert place(found) == ("c.yaml", 2, "joint_state_broadcaster/JointStateBroadcaster")


@pytest.mark.parametrize(
    "kind",
    [
        CLASS,
        "my_controllers/Drive",
        "diff_drive_controller/DiffDriveControler",  # RCT027
    ],
)
def test_what_may_be_there_is_calm(tmp_path: Path, kind: str) -> None:
    assert reported(tmp_path, "RCT036", DRIVE.replace(CLASS, kind)) == []
