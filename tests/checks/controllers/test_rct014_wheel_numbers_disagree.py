from __future__ import annotations

from pathlib import Path

import pytest

from tests.checks.controllers.test_rct013_controllers_name_unknown_joint import controller
from tests.controls import plugin
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot

DIFF = "diff_drive_controller/DiffDriveController"
ACKERMANN = "ackermann_steering_controller/AckermannSteeringController"
MECANUM = "mecanum_drive_controller/MecanumDriveController"


def wheel(name: str, x: float, y: float, radius: float = 0.1, shift: float = 0.0) -> str:
    """A wheel about y; its tyre is ``shift`` to the left of its joint."""
    return (
        f'<link name="{name}_link"><collision><origin xyz="0 {shift} 0" rpy="1.5707963 0 0"/>'
        f'<geometry><cylinder radius="{radius}" length="0.05"/></geometry></collision></link>'
        f'<joint name="{name}" type="continuous"><parent link="base"/><child link="{name}_link"/>'
        f'<origin xyz="{x} {y} 0"/><axis xyz="0 1 0"/></joint>'
    )


def robot(radius: float = 0.1, shift: float = 0.0) -> str:
    return '<link name="base"/>' + "".join(
        wheel(f"{end}{side}", x, sign * 0.2, radius, sign * shift)
        for end, x in (("f", 0.3), ("r", -0.3))
        for side, sign in (("l", 1), ("r", -1))
    )


def reported(folder: Path, text: str, model: str) -> list[Diagnostic]:
    (folder / "c.yaml").write_text(text)
    names = plugin("gz_ros2_control-system", f"<parameters>{folder}/c.yaml</parameters>")
    (folder / "r.urdf").write_text(whole_robot(model + names))
    report = check(folder / "r.urdf", select=["RCT014"])
    assert report.crashed == ()
    return list(report.diagnostics)


def drive(separation: float, radius: float) -> str:
    return controller(
        "d",
        DIFF,
        left_wheel_names="[fl, rl]",
        right_wheel_names="[fr, rr]",
        wheel_separation=str(separation),
        wheel_radius=str(radius),
    )


def test_separation(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, drive(0.3, 0.1), robot())
    assert found.message == ("controller 'd': wheel_separation is 0.3 m, but 0.4 m in the model")
    assert found.help == "write 0.4"
    assert found.span.source.path == str(tmp_path / "c.yaml")
    assert (found.span.line, found.span.text) == (6, "0.3")


def test_radius(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, drive(0.4, 0.2), robot())
    assert found.message == "controller 'd': wheel_radius is 0.2 m, but 0.1 m in the model"


@pytest.mark.parametrize(("separation", "radius"), [(0.4, 0.1), (0.419, 0.1049), (0.381, 0.0951)])
def test_within_calibration(tmp_path: Path, separation: float, radius: float) -> None:
    assert reported(tmp_path, drive(separation, radius), robot()) == []


def test_tyres_beside_their_joints(tmp_path: Path) -> None:
    model = robot(shift=0.05)
    assert reported(tmp_path, drive(0.5, 0.1), model) == [], "between the tyres"
    assert reported(tmp_path, drive(0.4, 0.1), model) == [], "between the joints"
    (found,) = reported(tmp_path, drive(0.6, 0.1), model)
    assert found.message.endswith("but 0.5 m in the model")


def test_what_the_model_does_not_tell(tmp_path: Path) -> None:
    mesh = robot().replace('<cylinder radius="0.1" length="0.05"/>', '<mesh filename="w.stl"/>')
    assert reported(tmp_path, drive(0.4, 7), mesh) == []
    assert reported(tmp_path, drive(0.4, 7), robot().replace('"0.1"', '"0.3"', 1)) == [], (
        "two sizes"
    )
    assert reported(tmp_path, drive(9, 9).replace("fl", "xl"), robot()) == [], "RCT013"
    assert reported(tmp_path, drive(9, 9).replace("9", "nine"), robot()) == []


def test_a_steered_car(tmp_path: Path) -> None:
    def car(wheelbase: float, track: float) -> str:
        return controller(
            "car",
            ACKERMANN,
            front_wheels_names="[fl, fr]",
            rear_wheels_names="[rl, rr]",
            wheelbase=str(wheelbase),
            rear_wheel_track=str(track),
        )

    assert reported(tmp_path, car(0.6, 0.4), robot()) == []
    found = reported(tmp_path, car(0.8, 0.5), robot())
    assert [one.message for one in found] == [
        "controller 'car': wheelbase is 0.8 m, but 0.6 m in the model",
        "controller 'car': rear_wheel_track is 0.5 m, but 0.4 m in the model",
    ]


def test_mecanum_wheels(tmp_path: Path) -> None:
    text = controller("m", MECANUM, front_left_wheel_command_joint_name="fl", kinematics="")
    (found,) = reported(tmp_path, text + "      wheels_radius: 0.3\n", robot())
    assert found.message == (
        "controller 'm': kinematics.wheels_radius is 0.3 m, but 0.1 m in the model"
    )
    assert reported(tmp_path, text + "      wheels_radius: 0.1\n", robot()) == []
