"""``urdfkit fix`` and ``urdfkit check --fix``: what they write, print and exit with."""

import os
from pathlib import Path

import pytest

from urdfkit.cli import main

AXIS = '    <axis xyz="0 1 0"/>\n'


@pytest.fixture
def robot(gazebo_pkg: Path) -> Path:
    """A copy of the mission's model."""
    return gazebo_pkg / "urdf" / "waking_robot_new.xacro"


def test_the_summary_lists_fixes_and_remaining_findings(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = ["fix", str(robot), "--select", "JNT,JNT020,INE008,GAZ045,XAC007"]
    assert main([*words, "--check"]) == 1
    assert "would fix in" in capsys.readouterr().out
    assert main(words) == 0
    out = capsys.readouterr().out
    assert out.replace(str(robot), "r.xacro") == (
        "fixed in r.xacro:\n"
        "  JNT020  remove the axis: lines 190, 220, 252\n"
        "\n"
        "left in r.xacro:\n"
        "  info     GAZ045  lidar-full-circle (unsafe fix: needs --unsafe-fixes): line\n"
        "      317\n"
        "  info     INE008  inertia-differs-from-geometry: line 15\n"
        "  info     INE008  inertia-differs-from-geometry (unsafe fix: needs\n"
        "      --unsafe-fixes): lines 214, 243, 269\n"
        "  info     JNT002  missing-limit: lines 158, 174, 181\n"
        "  info     JNT030  wrong-optical-frame: line 368\n"
        "  info     XAC007  own-pi (unsafe fix: needs --unsafe-fixes): line 9\n"
        "\n"
        "3 fixed in 1 file, 10 left, 5 of them with an unsafe fix (--unsafe-fixes)\n"
    )
    assert main([*words, "--check"]) == 0
    capsys.readouterr()
    assert main(["fix", str(robot), "--select", "JNT", "--fail-on", "info"]) == 1
    assert "0 fixed in 0 files, 4 left\n" in capsys.readouterr().out


def test_an_info_is_fixed_only_if_its_code_is_selected(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for words in ([], ["--select", "JNT"], ["--select", "JNT,INE", "--unsafe-fixes"]):
        assert main(["fix", str(robot), "--check", *words]) == 0
        out = " ".join(capsys.readouterr().out.split())
        assert "JNT020 ignored-axis-or-limit (fixed with --select JNT020): lines 190" in out
    for name in ("JNT020", "jnt020", "ignored-axis-or-limit"):
        assert main(["fix", str(robot), "--check", "--select", name]) == 1
        assert "3 would be fixed in 1 file, 0 left" in capsys.readouterr().out
    assert main(["check", str(robot), "--select", "JNT020"]) == 0
    assert "3 fixable with --fix\n" in capsys.readouterr().out
    assert main(["check", str(robot), "--select", "JNT"]) == 0
    out = capsys.readouterr().out
    assert "fixable" not in out
    assert "Fixes of infos need --select JNT020\n" in out


def test_fixes_that_another_fix_reveals_are_not_counted(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """A file that cannot be read has no infos yet: the summary named their codes."""
    robot.write_text(robot.read_text().replace("</robot>", "<!-- a -- b --></robot>", 1))
    assert main(["check", str(robot)]) == 1
    out = capsys.readouterr().out
    assert "1 fixable with --fix\n" in out
    assert "Fixes of infos" not in out


def test_a_check_counts_fixable_findings(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot.write_text(robot.read_text().replace("<robot", "<!-- do not edit -->\n<robot", 1))
    assert main(["check", str(robot), "--select", "JNT020,RCT029"]) == 1
    out = capsys.readouterr().out
    assert "fixable with" not in out
    assert "Not fixable: 4 (the file is generated: fix the file that it is generated from)\n" in out


def test_a_diff_writes_nothing(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = robot.read_bytes()
    for words in (["check", "--diff"], ["fix", "--diff"], ["check", "--fix", "--diff"]):
        assert main([*words, str(robot), "--select", "JNT020"]) == 1
        out = capsys.readouterr().out
        assert [line for line in out.splitlines() if line[:2] in ("- ", "+ ")] == [
            f"-{AXIS}".rstrip("\n")
        ] * 3
    assert robot.read_bytes() == before
    assert main(["check", "--diff", str(robot), "--select", "GEO"]) == 0
    assert capsys.readouterr().out == ""


def test_an_empty_diff_reports_remaining_findings(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["fix", "--diff", str(robot), "--select", "RCT029"]) == 0
    out, err = capsys.readouterr()
    assert out == ""  # a patch
    assert "0 would be fixed in 0 files, 1 left" in err
    assert main(["check", "--diff", str(robot), "--select", "RCT029"]) == 0
    assert "0 would be fixed in 0 files, " in capsys.readouterr().err
    assert main(["fix", "--diff", "-q", str(robot), "--select", "RCT029"]) == 0
    assert capsys.readouterr().err == ""


@pytest.mark.skipif(os.name == "nt", reason="Windows has no such modes")
def test_an_empty_diff_reports_the_reasons(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    robot.chmod(0o444)
    assert main(["fix", "--diff", str(robot), "--select", "JNT020"]) == 0
    out, err = capsys.readouterr()
    assert out == ""
    assert "\nnot fixable: 3 (the file is read-only" in err


def test_check_fixes_and_reports_remaining_findings(
    robot: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    before = robot.read_text()
    words = ["--select", "JNT,JNT020", "--format", "statistics"]
    assert main(["check", "--fix", str(robot), *words]) == 0
    captured = capsys.readouterr()
    assert captured.err == f"fixed {robot}\n"
    assert "JNT002" in captured.out
    assert "JNT020" not in captured.out
    assert robot.read_text().count("<axis") == before.count("<axis") - 3


@pytest.mark.parametrize(
    ("words", "error"),
    [
        (["check", "--fix", "-"], "standard input cannot be fixed in place"),
        (["check", "--unsafe-fixes", "r.urdf"], "--unsafe-fixes and --force need --fix or --diff"),
        (["fix"], "no file to check"),
        (["fix", "no.urdf"], "no.urdf: file not found"),
    ],
)
def test_usage_errors(words: list[str], error: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(words) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert error in captured.err


def test_an_unwritable_file_is_an_error(
    robot: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def full(*_: object) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.replace", full)
    before = robot.read_bytes()
    assert main(["fix", str(robot), "--select", "JNT020"]) == 2
    assert "No space left on device" in capsys.readouterr().err
    assert robot.read_bytes() == before
    assert [path.name for path in robot.parent.iterdir()] == [robot.name]


def test_missing_meshes_are_generated(robot: Path, capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("trimesh")
    mesh = robot.parents[1] / "meshes" / "hokuyo.dae"
    words = ["fix", str(robot), "--generate-meshes", "--select", "MSH", "--fail-on", "info"]
    assert main([*words, "--diff"]) == 1
    assert f"# would generate {mesh}:\n" in capsys.readouterr().out
    assert not mesh.exists()
    assert main(words) == 0
    out = capsys.readouterr().out
    assert out.startswith(f"generated {mesh}:\n  Hokuyo")
    assert out.endswith("\n0 fixed in 0 files, 0 left\n")
    assert main(["check", str(robot), "--select", "MSH", "--fail-on", "info"]) == 0


def test_meshes_of_other_workspaces_are_not_generated(
    robot: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("trimesh")
    other = tmp_path / "elsewhere" / "gazebo_pkg"
    other.mkdir(parents=True)
    (other / "package.xml").write_text("<package><name>gazebo_pkg</name></package>")
    words = ["fix", str(robot), "--generate-meshes", "--package", f"gazebo_pkg={other}"]
    assert main(words) == 0
    assert "cannot generate" in capsys.readouterr().out
    assert [path.name for path in other.iterdir()] == ["package.xml"]
