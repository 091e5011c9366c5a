"""The tree command."""

from pathlib import Path

import pytest

from tests.shipped import GRIPPER
from urdfkit.cli import main
from urdfkit.output.diagrams import FORMATS


@pytest.mark.parametrize("form", FORMATS)
def test_every_format_names_every_link(form: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tree", GRIPPER, "--format", form]) == 0
    drawn = capsys.readouterr().out
    assert all(name in drawn for name in ("mount", "palm", "left_finger", "right_finger"))


def test_a_missing_file_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["tree", "no.urdf"]) == 2
    assert capsys.readouterr().out == ""


def test_a_launch_file_without_a_robot(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The error has no finding behind it: it once was its own cause, and the command hung."""
    launch = tmp_path / "view.launch.py"
    launch.write_text("def generate_launch_description(): pass\n")
    assert main(["tree", str(launch)]) == 2
    assert "describes no robot" in capsys.readouterr().err


@pytest.mark.parametrize("command", ["tree", "info", "mass", "kinematics", "statics"])
def test_control_characters_in_names_are_escaped(
    command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """U+009B begins a control sequence, U+202E turns the direction of writing."""
    if command == "statics":
        pytest.importorskip("pinocchio")
    body = (
        '<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
        "</inertial>"
    )
    file = tmp_path / "r.urdf"
    file.write_text(
        f'<robot name="r&#x9b;2J"><link name="a&#x202e;b">{body}</link></robot>', encoding="utf-8"
    )
    assert main([command, str(file)]) == 0
    drawn = capsys.readouterr().out
    assert "\x9b" not in drawn
    assert "\u202e" not in drawn
