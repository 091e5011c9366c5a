"""RCT026: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported
from tests.naming import naming


@pytest.mark.parametrize(
    ("old", "new", "line", "text"),
    [
        ("drive:\n  ros__parameters", "drive:\n  ros_parameters", 6, "ros_parameters"),
        ("manager:\n  ros__p", "manager:\n  ros_p", 2, "ros_parameters"),
        ("\ndrive:", "\ndriev:", 5, "driev"),
        ("\ndrive:", "\n/**/dirve:", 5, "/**/dirve"),
    ],
)
def test_keys_that_are_not_read(tmp_path: Path, old: str, new: str, line: int, text: str) -> None:
    (found,) = reported(tmp_path, "RCT026", DRIVE.replace(old, new))
    assert place(found) == ("c.yaml", line, text)


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [("    wheel_sep", "\twheel_sep", 9), ("[left_joint]", "[left_joint", 8)],
)
def test_invalid_yaml(tmp_path: Path, old: str, new: str, line: int) -> None:
    (found,) = reported(tmp_path, "RCT026", DRIVE.replace(old, new))
    assert found.message.startswith("invalid YAML: ")
    assert found.span.line == line


@pytest.mark.parametrize(
    ("old", "new"),
    [
        # libyaml, by which ROS 2 reads parameters, accepts tabs that PyYAML does not.
        ("[left_joint]", "[left_joint]\t# of the left side"),
        ("separation: ", "separation:\t"),
        ("\ndrive:", "\n/**/drive:"),
        ("\ndrive:", "\n/robot/drive:"),
        ("\ndrive:", "\nother:"),  # the controller may have its parameters elsewhere
    ],
)
def test_parameters_that_may_be_read_are_accepted(tmp_path: Path, old: str, new: str) -> None:
    assert reported(tmp_path, "RCT026", DRIVE.replace(old, new)) == []


def test_parameters_outside_of_ros_parameters(tmp_path: Path) -> None:
    text = DRIVE.replace("drive:\n  ros__parameters:\n    left", "drive:\n    left")
    (found,) = reported(tmp_path, "RCT026", text)
    assert place(found) == ("c.yaml", 5, "drive")


def test_a_manager_without_ros_parameters(tmp_path: Path) -> None:
    text = DRIVE.replace("manager:\n  ros__parameters:\n", "manager:\n")
    (found,) = reported(tmp_path, "RCT026", text)
    assert place(found) == ("c.yaml", 1, "controller_manager")
    assert found.message == naming("ROS 2", "controller_manager", "ros__parameters")


@pytest.mark.parametrize(
    ("old", "new", "text"),
    [
        ("      type: diff", "    type: diff", "diff_drive_controller/DiffDriveController"),
        ("      type: diff", "      typ: diff", "typ"),
    ],
)
def test_type_that_is_not_a_controller(tmp_path: Path, old: str, new: str, text: str) -> None:
    (found,) = reported(tmp_path, "RCT026", DRIVE.replace(old, new))
    assert place(found) == ("c.yaml", 4, text)


@pytest.mark.parametrize(
    ("key", "namespace", "count"),
    [
        ("controller_manager", "r1", 1),
        ("controller_manager", "/r1/", 1),
        ("r2/controller_manager", "r1", 1),
        ("r1/controller_manager", "r1", 0),
        ("/r1/controller_manager", "/r1", 0),
        ("/**/controller_manager", "r1", 0),
        ("controller_manager", "", 0),
        ("controller_manager", "/", 0),
    ],
)
def test_a_manager_in_a_namespace(tmp_path: Path, key: str, namespace: str, count: int) -> None:
    text = DRIVE.replace("controller_manager", key)
    found = reported(tmp_path, "RCT026", text, namespace=namespace)
    assert [place(one) for one in found] == [("c.yaml", 1, key)] * count
