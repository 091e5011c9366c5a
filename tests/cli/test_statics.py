"""The statics command."""

import json
import sys
from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.shipped import ARM
from urdfkit.cli import main
from urdfkit.core.installation import install_command
from urdfkit.robot.samples import arm_xml

BASE = str(MODELS / "good" / "mobile_base" / "urdf" / "mobile_base.urdf.xacro")


def test_the_weakest_joint_and_the_required_effort(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    assert main(["statics", ARM, "--payload", "5kg@forearm"]) == 0
    page = capsys.readouterr().out
    assert "highest load: shoulder, at shoulder " in page
    assert "shoulder exceeds its effort limit: needs >= 23.14 N·m" in page
    assert "margin 0.0597 m; tips over" in page.replace("0.05971", "0.0597")


def test_a_base_on_wheels(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    assert main(["statics", BASE]) == 0
    page = capsys.readouterr().out
    assert "stands on left_wheel, right_wheel, caster\n" in page
    assert "\n\n\n" not in page


def test_links_without_gravity_in_gazebo_have_no_weight(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """DYN003 leaves them out, too."""
    pytest.importorskip("pinocchio")
    flag = '<gazebo reference="forearm"><turnGravityOff>true</turnGravityOff></gazebo></robot>'
    text = Path(ARM).read_text(encoding="utf-8").replace("</robot>", flag)
    (tmp_path / "arm.urdf").write_text(text, encoding="utf-8")
    assert main(["statics", str(tmp_path / "arm.urdf"), "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert "forearm" in found["weightless"]
    assert {one["joint"]: one["worst"] for one in found["joints"]}["elbow"] == 0
    assert main(["statics", str(tmp_path / "arm.urdf")]) == 0
    assert "no gravity in Gazebo on" in capsys.readouterr().out


def test_a_robot_fixed_to_the_world_cannot_tip_over(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("pinocchio")
    text = Path(ARM).read_text(encoding="utf-8").replace('"mount"', '"world"')
    (tmp_path / "arm.urdf").write_text(text, encoding="utf-8")
    assert main(["statics", str(tmp_path / "arm.urdf")]) == 0
    page = capsys.readouterr().out
    assert page.endswith("\n\nfixed to the world: cannot tip over\n")
    assert max(map(len, page.splitlines())) <= 80


def test_a_robot_without_mass_has_no_loads(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """GRobot of clampforklift_ws2 had 23 rows of zeros."""
    file = tmp_path / "a.urdf"
    file.write_text(f'<robot name="r">{arm_xml("continuous")}</robot>')
    assert main(["statics", str(file)]) == 0
    lines = capsys.readouterr().out.split("\n")
    assert lines[:2] == ["gravity on 0 kg, no link has a mass", ""]
    assert not any(line.startswith("joint") for line in lines)


def test_contact_links_fit_a_terminal(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    text = Path(ARM).read_text(encoding="utf-8").replace('"base"', f'"{"base_" * 15}"')
    (tmp_path / "arm.urdf").write_text(text, encoding="utf-8")
    assert main(["statics", str(tmp_path / "arm.urdf"), "--contact", "base_" * 15]) == 0
    assert f"stands on\n  {'base_' * 15}\n" in capsys.readouterr().out


def test_json(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    words = ["--format", "json", "--samples", "10", "--contact", "base", "--joint", "shoulder=1.4"]
    assert main(["statics", ARM, *words]) == 0
    document = json.loads(capsys.readouterr().out)
    assert document["weakest"] == "shoulder"
    assert [joint["joint"] for joint in document["joints"]] == ["shoulder", "elbow"]
    assert document["joints"][0]["exceeded"] is False
    assert document["stability"]["tips"] is True
    assert document["stability"]["links"] == ["base"]


def test_missing_pinocchio_is_reported(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    monkeypatch.delitem(sys.modules, "urdfkit.physics.dynamics.robot", raising=False)
    assert main(["statics", ARM]) == 2
    assert install_command("dynamics") in capsys.readouterr().err


@pytest.mark.parametrize(
    ("words", "reported"),
    [
        (["--payload", "5"], "--payload 5: expected KG@LINK: a mass in kg and a link"),
        (
            ["--payload", "x@forearm"],
            "--payload x@forearm: expected KG@LINK: a mass in kg and a link",
        ),
        (["--payload", "5@foream"], "no link 'foream'; did you mean 'forearm'?"),
        (["--payload", "1e300@forearm"], "is implausible: 1e+300 kg"),
        (
            ["--payload=-1@forearm"],
            "--payload -1@forearm: expected KG@LINK: a mass in kg and a link",
        ),
        (["--contact", "bse"], "no link 'bse'; did you mean 'base'?"),
        (["--samples", "-1"], "-1 is not in the range"),
    ],
)
def test_usage_errors(words: list[str], reported: str, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    assert main(["statics", ARM, *words]) == 2
    assert reported in capsys.readouterr().err
