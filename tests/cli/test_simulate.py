"""The simulate command: what it prints, and its exit codes."""

import json
from pathlib import Path
from xml.etree import ElementTree

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
        '<origin xyz="{1} {1} 0"/><axis xyz="0 0 1"/></joint>'
    )
    links = "".join(f'<link name="{name}">{inertial}{box}</link>\n' for name in "ab")
    joints = "".join(map(joint.format, "ab", ("0", "0.8")))
    file = tmp_path / "boxes.urdf"
    file.write_text(f'<robot name="r"><link name="world"/>\n{links}{joints}</robot>')
    assert main(["simulate", str(file)]) == 1
    text = capsys.readouterr().out
    assert "warns overlap: links 'a' and 'b' overlap" in text
    assert "FAILS energy: released" in text
    assert main(["simulate", str(file), "--format", "json"]) == 1
    found = json.loads(capsys.readouterr().out)
    assert (found["base"], found["passes"]) == ("fixed", False)
    keys = ("test", "passes", "warns", "line")
    assert [[one[key] for key in keys] for one in found["verdicts"][:2]] == [
        ["overlap", True, True, 2],
        ["energy", False, False, 2],
    ]
    assert main(["simulate", str(file), "--format", "junit"]) == 1
    (suite,) = ElementTree.fromstring(capsys.readouterr().out)
    assert suite.get("tests") == str(len(found["verdicts"]))
    assert suite.get("failures") == str(sum(not one["passes"] for one in found["verdicts"]))
    warning, failure = suite[0], suite[1]
    assert (warning.get("name"), warning.get("line")) == ("overlap a b", "2")
    assert (warning[0].tag, failure[0].tag) == ("system-out", "failure")
    assert "overlap by" in (warning[0].text or "")
    assert "push each other away" in failure[0].attrib["message"]


def test_what_cannot_be_simulated(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (tmp_path / "two.urdf").write_text('<robot name="r"><link name="a"/><link name="b"/></robot>')
    assert main(["simulate", str(tmp_path / "two.urdf")]) == 2
    assert "do not form one tree" in capsys.readouterr().err


def test_its_release_is_drawn(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    image = pytest.importorskip("PIL.Image")
    from urdfkit.cli import simulate
    from urdfkit.render import animation

    monkeypatch.setattr(simulate, "SIZE", (64, 40))
    monkeypatch.setattr(simulate, "MOVING", (64, 40))
    monkeypatch.setattr(animation, "FRAMES", 4)
    gif, png = tmp_path / "a.gif", tmp_path / "a.png"
    assert main(["simulate", str(ARM), "--gif", str(gif), "--png", str(png)]) == 0
    with image.open(gif) as moving, image.open(png) as still:
        assert (moving.format, moving.size) == ("GIF", (64, 40))
        assert (still.format, still.size) == ("PNG", (64, 40))
    assert main(["simulate", str(ARM), "--gif", str(tmp_path / "a.jpg")]) == 2
