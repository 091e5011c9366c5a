"""RCT040: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.checks.controllers.test_rct013_controllers_name_unknown_joint import controller
from tests.controls import GZ, ROBOT, control, driven, plugin
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot

OFFERED = control(driven("swing", "velocity", "velocity"), driven("slide"), plugin=GZ)
DRIVE = "diff_drive_controller/DiffDriveController"


def reported(folder: Path, text: str, blocks: str = OFFERED) -> list[Diagnostic]:
    (folder / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"<parameters>{folder}/c.yaml</parameters>")
    (folder / "r.urdf").write_text(whole_robot(ROBOT + blocks + names))
    report = check(folder / "r.urdf", select=["RCT040"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_a_trajectory_controller_says_which(tmp_path: Path) -> None:
    text = controller("arm", joints="[swing, slide]", state_interfaces="[position, velocity]")
    first, second = reported(tmp_path, text)
    assert first.message == (
        "controller 'arm' needs the position of joint 'swing', whose state interfaces are: velocity"
    )
    assert (first.span.line, first.span.text) == (4, "swing")
    assert second.message.endswith(
        "the velocity of joint 'slide', whose state interfaces are: position"
    )


@pytest.mark.parametrize(
    ("feedback", "joint", "needs"),
    [
        ({}, "swing", "position"),
        ({"position_feedback": "false"}, "slide", "velocity"),
        ({"position_feedback": "True"}, "swing", "position"),
    ],
)
def test_wheels(tmp_path: Path, feedback: dict[str, str], joint: str, needs: str) -> None:
    (found,) = reported(tmp_path, controller("d", DRIVE, left_wheel_names=f"[{joint}]", **feedback))
    assert f"needs the {needs} of joint '{joint}'" in found.message


def test_a_gripper(tmp_path: Path) -> None:
    kind = "position_controllers/GripperActionController"
    (found,) = reported(tmp_path, controller("g", kind, joint="slide"))
    assert "needs the velocity of joint 'slide'" in found.message


@pytest.mark.parametrize(
    "text",
    [
        controller("d", DRIVE, left_wheel_names="[swing]", position_feedback="false"),
        controller("d", DRIVE, left_wheel_names="[swing]", open_loop="true"),
        controller("arm", joints="[slide]", state_interfaces="[position]"),
        controller("arm", joints="[slide]"),
        controller("arm", "acme/Own", joints="[slide]", state_interfaces="[effort]"),
        controller("arm", joints="[follow]", state_interfaces="[effort]"),
    ],
)
def test_offered_or_unknown_is_calm(tmp_path: Path, text: str) -> None:
    assert reported(tmp_path, text) == []
