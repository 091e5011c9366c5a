"""RCT027: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("wheel_separation", "wheel_seperation", 9),
        ("wheel_radius", "wheels_radius", 10),
        ("base_frame_id", "base_frame_idd", 11),
    ],
)
def test_a_misspelt_parameter(tmp_path: Path, old: str, new: str, line: int) -> None:
    (found,) = reported(tmp_path, "RCT027", DRIVE.replace(old, new))
    assert found.message == f"controller 'drive': '{new}' is nearly '{old}'"
    assert place(found) == ("c.yaml", line, new)


def test_a_misspelt_type(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT027", DRIVE.replace("/DiffDriveC", "/DiffDirveC"))
    assert found.help == "write diff_drive_controller/DiffDriveController"
    assert found.span.line == 4


def test_what_is_no_slip_is_calm(tmp_path: Path) -> None:
    more = DRIVE + "    linear.x.max_velocity: 1.0\n    angular:\n      z:\n        max_jerk: 1.0\n"
    assert reported(tmp_path, "RCT027", more + "    our_own: 1\n") == []
    assert reported(tmp_path, "RCT027", DRIVE.replace("diff_drive_controller/", "our_drive/")) == []
