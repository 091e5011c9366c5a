from __future__ import annotations

from pathlib import Path

import pytest

from tests.checks.test_rct013_controllers_name_unknown_joint import TRAJECTORY, controller
from tests.controls import GZ, ROBOT, control, driven, plugin
from urdfkit import Diagnostic, check
from urdfkit.examples import whole_robot

OFFERED = control(driven("swing", "velocity"), driven("slide", "position"), plugin=GZ)


def told(folder: Path, text: str, blocks: str = OFFERED) -> list[Diagnostic]:
    (folder / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"<parameters>{folder}/c.yaml</parameters>")
    (folder / "r.urdf").write_text(whole_robot(ROBOT + blocks + names))
    report = check(folder / "r.urdf", select=["RCT021"])
    assert report.crashed == ()
    return list(report.diagnostics)


def test_a_trajectory_controller_says_which(tmp_path: Path) -> None:
    text = controller("arm", joints="[swing, slide]", command_interfaces="[position, acceleration]")
    first, second = told(tmp_path, text)
    assert first.message == (
        "controller 'arm' commands the position and the acceleration of joint 'swing', whose "
        "command interfaces are: velocity"
    )
    assert (first.span.line, first.span.text) == (4, "swing")
    assert second.message.endswith(
        "acceleration of joint 'slide', whose command interfaces are: position"
    )


@pytest.mark.parametrize(
    ("kind", "names", "joint"),
    [
        ("velocity_controllers/JointGroupVelocityController", "joints", "slide"),
        ("effort_controllers/JointGroupEffortController", "joints", "swing"),
        ("position_controllers/JointGroupPositionController", "joints", "swing"),
        ("diff_drive_controller/DiffDriveController", "left_wheel_names", "slide"),
    ],
)
def test_the_type_says_which(tmp_path: Path, kind: str, names: str, joint: str) -> None:
    (found,) = told(tmp_path, controller("c", kind, **{names: f"[{joint}]"}))
    assert found.message.startswith("controller 'c' commands the ")
    good = "slide" if joint == "swing" and "effort" not in kind else "swing"
    others = told(tmp_path, controller("c", kind, **{names: f"[{good}]"}))
    assert len(others) == ("effort" in kind)


def test_what_is_not_known_is_not_judged(tmp_path: Path) -> None:
    velocity = controller("arm", joints="[swing]", command_interfaces="[position]")
    assert told(tmp_path, velocity, "") == []  # no block at all
    assert told(tmp_path, controller("arm", joints="[swing]")) == []
    assert told(tmp_path, controller("arm", "acme/Own", joints="[swing]")) == []
    other = controller(
        "arm", joints="[swing]", command_joints="[pid/swing]", command_interfaces="[position]"
    )
    assert told(tmp_path, other) == []
    assert TRAJECTORY in other
