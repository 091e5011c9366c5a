"""The convert command: what it prints, and its exit codes."""

import json
import sys
from pathlib import Path

import pytest

from tests.conftest import GRIPPER
from urdfkit.cli import main
from urdfkit.core.installation import install_command

for library in ("mujoco", "pinocchio", "trimesh"):
    pytest.importorskip(library)


def convert(*words: str) -> int:
    return main(["convert", str(GRIPPER), "--to", "mjcf", "-o", "out", *words])


@pytest.fixture(autouse=True)
def _here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)


def test_losses_are_reported(capsys: pytest.CaptureFixture[str]) -> None:
    assert convert() == 0
    text = " ".join(capsys.readouterr().out.split())
    assert text.startswith(
        "wrote out: gripper.xml; its root is welded to the world"
        " 4 links, 2 joints, 6 geoms, 1 actuator MuJoCo and Pinocchio agree on frames, inertia,"
    )
    assert "lost: velocity: MuJoCo does not limit velocities (" in text
    assert text.endswith("gripper.urdf:65:57, and 1 more place)")


def test_lost_links_are_counted(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A person of 48 links was one link in Gazebo, and the page began with its proof."""
    mass = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    (tmp_path / "r.urdf").write_text(
        f'<robot name="r"><link name="a">{mass}</inertial></link><link name="b"/>'
        '<joint name="j" type="revolute"><parent link="a"/><child link="b"/>'
        '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
    )
    assert main(["convert", "r.urdf", "--to", "sdf", "-o", "out"]) == 0
    assert "\n  lost 1 of 2 links: see below\n" in capsys.readouterr().out


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    assert convert("--format", "json", "--base", "free") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["base"] == "free"
    assert found["proof"]["holds"] is True
    assert found == json.loads(Path("out/conversion.json").read_text(encoding="utf-8"))


def test_an_existing_output_is_an_error(capsys: pytest.CaptureFixture[str]) -> None:
    assert convert() == 0
    assert convert() == 2
    assert "--force replaces it" in capsys.readouterr().err
    assert convert("--force") == 0


def test_a_directory_of_something_else_is_not_replaced(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """The error said that a bundle is no bundle."""
    Path("out").mkdir()
    Path("out/bundle.json").write_text("{}")
    assert convert("--force") == 2
    assert "out: is a directory without conversion.json" in capsys.readouterr().err


def test_missing_mujoco_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    for module in [name for name in sys.modules if name.startswith("urdfkit.output.conversion.")]:
        monkeypatch.delitem(sys.modules, module)
    monkeypatch.setitem(sys.modules, "mujoco", None)
    assert convert() == 2
    assert install_command("simulate") in capsys.readouterr().err
