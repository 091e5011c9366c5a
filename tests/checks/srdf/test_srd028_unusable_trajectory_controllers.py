"""SRD028: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming, values
from tests.srdfs import TRAJECTORY_CONTROLLERS, WITHOUT_MANAGER, findings, findings_in
from urdfkit import Severity

MANAGER = (
    "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    type: GripperCommand\n"
)
PLUGIN = (
    "moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager\n"
)


@pytest.mark.parametrize(
    ("file", "text", "line", "message", "help"),
    [
        (
            "moveit_controllers.yaml",
            "trajectory_execution:\n  a: 1\nallowed_start_tolerance: 0.1\n",
            3,
            naming("allowed_start_tolerance", "trajectory_execution"),
            "indent it below trajectory_execution:",
        ),
        (
            "moveit_controllers.yaml",
            "trajectory_execution:\n  allowed_start_tolerence: 0.1\n",
            2,
            "trajectory_execution has no 'allowed_start_tolerence'",
            "write allowed_start_tolerance",
        ),
        (
            "moveit_controllers.yaml",
            MANAGER + "    joint: [shoulder]\n",
            5,
            naming("c", "joint"),
            "write joints",
        ),
        (
            "moveit_controllers.yaml",
            MANAGER + "    joints: [shoulder]\n  d: {type: a, joints: [shoulder]}\n",
            6,
            naming("d", "controller_names", "MoveIt"),
            "add d to controller_names",
        ),
    ],
)
def test_settings_without_effect(
    tmp_path: Path, file: str, text: str, line: int, message: str, help: str
) -> None:
    assert (line, Severity.WARNING.name, message, help) in findings_in(
        tmp_path, file, text, "SRD028"
    )


@pytest.mark.parametrize(
    ("file", "text"),
    [
        ("moveit_controllers.yaml", "trajectory_execution:\n  allowed_start_tolerance: 0.1\n"),
        ("moveit_controllers.yaml", "moveit_manage_controllers: true\nmine: 1\n"),
        (
            "moveit_controllers.yaml",
            PLUGIN + MANAGER + "    joints: [shoulder]\n    action_ns: b\n",
        ),
    ],
)
def test_settings_that_are_read(tmp_path: Path, file: str, text: str) -> None:
    assert findings_in(tmp_path, file, text, "SRD028") == []


@pytest.mark.parametrize(
    ("kind", "help"),
    [
        ("JointGroupPositionController", "write FollowJointTrajectory, or GripperCommand"),
        ("FollowJointTrajectoy", "write FollowJointTrajectory"),
    ],
)
def test_a_type_that_moveit_does_not_have(tmp_path: Path, kind: str, help: str) -> None:
    text = PLUGIN + MANAGER.replace("GripperCommand", kind) + "    joints: [shoulder]\n"
    found_in = findings_in(tmp_path, "moveit_controllers.yaml", text, "SRD028")
    ((line, severity, message, found),) = found_in
    assert (line, severity, message) == (5, "ERROR", naming("c", kind, "MoveIt"))
    assert found.startswith(help)
    assert findings_in(tmp_path, "moveit_controllers.yaml", text, "SRD029") == []


@pytest.mark.parametrize(("joints", "count"), [("[]", 1), ("", 1), ("[shoulder]", 0)])
def test_a_list_without_joints(tmp_path: Path, joints: str, count: int) -> None:
    text = PLUGIN + MANAGER + f"    joints: {joints}\n"
    found = findings_in(tmp_path, "moveit_controllers.yaml", text, "SRD028")
    assert ["has no joints" in message for _, _, message, _ in found] == [True] * count


@pytest.mark.parametrize("package", [True, False])
def test_settings_of_a_controller_manager_that_move_group_does_not_load(
    tmp_path: Path, package: bool
) -> None:
    if package:
        (tmp_path / "package.xml").write_text('<package format="3"><name>p</name></package>')
    found = findings_in(tmp_path, "moveit_controllers.yaml", MANAGER, "SRD028")
    names = ["moveit_controller_manager", "move_group", "moveit_simple_controller_manager"]
    assert (names in [values(text) for _, _, text, _ in found]) == package


@pytest.mark.parametrize(("text", "line"), [(TRAJECTORY_CONTROLLERS, 2), (WITHOUT_MANAGER, 1)])
def test_names_without_settings(tmp_path: Path, text: str, line: int) -> None:
    path = tmp_path / "moveit_controllers.yaml"
    path.write_text(text)
    assert findings(tmp_path, "", "SRD028") == []
    path.write_text(text.replace("[arm_controller]", "[arm_controler]"))
    (found,) = findings(tmp_path, "", "SRD028")
    assert (found.span.source.path, found.span.line) == (str(path), line)
    assert found.message == naming("arm_controler", "arm_controller")


def test_settings_one_level_too_high(tmp_path: Path) -> None:
    text = (
        TRAJECTORY_CONTROLLERS.replace("[arm_controller]", "[arm_controller, hand]")
        + "hand:\n  joints: [knuckle]\n"
    )
    (tmp_path / "moveit_controllers.yaml").write_text(text)
    (found,) = findings(tmp_path, "", "SRD028")
    assert found.message == naming("hand", "moveit_simple_controller_manager")
    assert found.help == "indent the settings"
