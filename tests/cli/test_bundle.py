"""The bundle command: what it prints, and its exit codes."""

from pathlib import Path

import pytest

from tests.conftest import ARM
from urdfkit.cli import main

pytest.importorskip("trimesh")


def test_the_summary_lists_the_output(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["bundle", str(ARM), "-o", "out", "--for", "web"]) == 0
    assert capsys.readouterr().out == "wrote out: two_link_arm.urdf, 2 mesh files, 28 kB\n"


def test_a_rejected_robot_exits_with_1(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot = tmp_path / "robot.urdf"
    robot.write_bytes(ARM.read_bytes().replace(b'izz="0.0054"', b'izz="5"'))
    (tmp_path / "meshes").symlink_to(ARM.parents[1] / "meshes")
    words = ["--package", f"two_link_arm={ARM.parents[1]}"]
    out = str(tmp_path / "out")
    assert main(["bundle", str(robot), "-o", out, "--for", "mujoco", *words]) == 1
    told = capsys.readouterr().out.split("errors for MuJoCo:")[1]
    assert "INE003" in told
    assert main(["bundle", str(robot), "-o", out, "--force", *words]) == 0


def test_an_unwritable_output_exits_with_2(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["bundle", str(ARM), "-o", str(tmp_path)]) == 0
    assert main(["bundle", str(ARM), "-o", str(tmp_path)]) == 2
    assert "--force replaces it" in capsys.readouterr().err


def test_a_directory_cannot_be_standard_output(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["bundle", str(ARM), "-o", "-"]) == 2
    assert "'-' is not a directory" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []
