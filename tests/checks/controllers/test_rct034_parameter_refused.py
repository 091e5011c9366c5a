"""RCT034: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported


@pytest.mark.parametrize(
    ("old", "new", "line", "text", "help"),
    [
        ("wheel_radius: 0.1", "wheel_radius: 1", 10, "1", "write 1.0"),
        ("wheel_radius: 0.1", "wheel_radius: 0,1", 10, "0,1", "write 0.1"),
        ("wheel_radius: 0.1", "wheel_radius: '0.1'", 10, "'0.1'", "write 0.1"),
        ("wheel_radius: 0.1", "wheel_radius: wide", 10, "wide", "write a number with a point"),
        ("[left_joint]", "left_joint", 7, "left_joint", "write a list of texts"),
        ("frame_id: base", "frame_id: 1", 11, "1", "write a text"),
        ("ers:\n    drive", "ers:\n    update_rate: 9.0\n    drive", 3, "9.0", "write 9"),
    ],
)
def test_other_types_than_the_node_declares(
    tmp_path: Path, old: str, new: str, line: int, text: str, help: str
) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace(old, new))
    assert place(found) == ("c.yaml", line, text)
    assert found.help == help


@pytest.mark.parametrize("rate", ["0", "-5"])
def test_rates_of_nothing(tmp_path: Path, rate: str) -> None:
    text = DRIVE.replace("ers:\n    drive", f"ers:\n    update_rate: {rate}\n    drive")
    (found,) = reported(tmp_path, "RCT034", text)
    assert found.message == f"the controller manager: update_rate is {rate}, and must be above 0"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("wheel_radius: 0.1", "wheel_radius: $(var radius)"),  # filled in by launch
        ("wheel_radius: 0.1", "wheel_radius: 1e-1"),
        ("wheel_radius: 0.1", "wheel_radius:"),
        ("diff_drive_controller/Diff", "my_drive_controller/Diff"),
        ("frame_id: base", "frame_id: 'base'"),
    ],
)
def test_what_ros_takes_is_calm(tmp_path: Path, old: str, new: str) -> None:
    assert reported(tmp_path, "RCT034", DRIVE.replace(old, new)) == []
