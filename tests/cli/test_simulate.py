"""The simulate command: what it prints, and its exit codes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from tests.conftest import MODELS
from urdfkit.cli import main

for library in ("mujoco", "trimesh"):
    pytest.importorskip(library)
ARM = MODELS / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf"


def test_a_robot_that_behaves(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["simulate", str(ARM)]) == 0
    assert capsys.readouterr().out.splitlines()[:2] == [
        "its root is welded to the world",
        "  passes overlap: no links overlap at the start",
    ]


def test_one_that_does_not(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    box = '<collision><geometry><box size="1 1 1"/></geometry></collision>'
    inertial = (
        '<inertial><mass value="1"/>'
        '<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>'
    )
    joint = (
        '<joint name="{0}" type="continuous"><parent link="world"/><child link="{0}"/>'
        '<axis xyz="0 0 1"/></joint>'
    )
    links = "".join(f'<link name="{name}">{inertial}{box}</link>\n' for name in "ab")
    joints = "".join(map(joint.format, "ab"))
    file = tmp_path / "boxes.urdf"
    file.write_text(f'<robot name="r"><link name="world"/>\n{links}{joints}</robot>')
    assert main(["simulate", str(file)]) == 1
    assert "FAILS overlap: links 'a' and 'b' overlap" in capsys.readouterr().out
    assert main(["simulate", str(file), "--format", "json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["base"], found["passes"]) == ("fixed", False)
    assert [found["verdicts"][0][key] for key in ("test", "line")] == ["overlap", 2]


def test_what_cannot_be_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "two.urdf").write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert main(["simulate", str(tmp_path / "two.urdf")]) == 2
    assert "do not form one tree" in capsys.readouterr().err
