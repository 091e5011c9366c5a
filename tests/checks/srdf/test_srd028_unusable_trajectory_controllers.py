"""SRD028: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming, values
from tests.srdfs import findings
from urdfkit import Severity

GROUP = '<group name="g"><chain base_link="base" tip_link="hand"/></group>'
MANAGER = "moveit_simple_controller_manager:\n  controller_names: [c]\n  c:\n    type: a\n"
PLUGIN = (
    "moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager\n"
)


def reported(directory: Path, file: str, text: str) -> list[tuple[int, str, str, str]]:
    """Line, severity, message and help of each finding in a file next to the SRDF."""
    (directory / file).write_text(text)
    return [
        (found.span.line, found.severity.name, found.message, found.help)
        for found in findings(directory, GROUP, "SRD028")
        if found.span.source.path == str(directory / file)
    ]


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
    assert (line, Severity.WARNING.name, message, help) in reported(tmp_path, file, text)


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
    assert reported(tmp_path, file, text) == []


@pytest.mark.parametrize("package", [True, False])
def test_settings_of_a_controller_manager_that_move_group_does_not_load(
    tmp_path: Path, package: bool
) -> None:
    if package:
        (tmp_path / "package.xml").write_text('<package format="3"><name>p</name></package>')
    found = reported(tmp_path, "moveit_controllers.yaml", MANAGER)
    names = ["moveit_controller_manager", "move_group", "moveit_simple_controller_manager"]
    assert (names in [values(text) for _, _, text, _ in found]) == package


TWO = """\
moveit_simple_controller_manager:
  controller_names: [arm_controller]
  arm_controller:
    type: FollowJointTrajectory
    joints: [shoulder, wrist, knuckle]
"""
#: Launch files of their own pass the whole file as the settings of the manager.
FLAT = """\
controller_names: [arm_controller]
arm_controller: {type: FollowJointTrajectory, joints: [shoulder, wrist, knuckle]}
"""


@pytest.mark.parametrize(("text", "line"), [(TWO, 2), (FLAT, 1)])
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
        TWO.replace("[arm_controller]", "[arm_controller, hand]") + "hand:\n  joints: [knuckle]\n"
    )
    (tmp_path / "moveit_controllers.yaml").write_text(text)
    (found,) = findings(tmp_path, "", "SRD028")
    assert found.message == naming("hand", "moveit_simple_controller_manager")
    assert found.help == "indent the settings"
