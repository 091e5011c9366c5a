"""The kinematics command: frames for all, matrices with Pinocchio."""

import io
import itertools
import json
import sys
from math import cos, pi, sin
from pathlib import Path

import pytest

from tests.massive import inertial, joint, link
from tests.shipped import ARM
from urdfkit.cli import main
from urdfkit.core.installation import install_command
from urdfkit.lint.rule_examples import whole_robot

TWO = whole_robot(link("a") + link("b") + joint("a", "b") + link("c"))


def test_frames_at_a_pose(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["kinematics", ARM, "--joint", "shoulder=30deg"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[-1].split() == ["forearm", "0.1800", "0.0000", "0.4568", "0.00", "30.00", "0.00"]


def test_a_transform(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["--transform", "upper_arm", "forearm", "--joint", "elbow=0.5", "--format", "json"]
    assert main(["kinematics", ARM, *words]) == 0
    found = json.loads(capsys.readouterr().out)["transform"]
    assert found["position"] == [0, 0, 0.36]
    assert found["rpy"] == pytest.approx([0, 0.5, 0])


def test_matrices(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("pinocchio")
    words = ["--jacobian", "forearm", "--mass-matrix", "--joint", f"shoulder={pi / 3}"]
    assert main(["kinematics", ARM, *words, "--format", "json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["columns"] == ["shoulder", "elbow"]
    assert [row[0] for row in found["jacobian"]] == pytest.approx(
        [0.36 * cos(pi / 3), 0, -0.36 * sin(pi / 3), 0, 1, 0]
    )
    matrix = found["mass_matrix"]
    assert matrix[0][1] == matrix[1][0]
    assert main(["kinematics", ARM, *words]) == 0
    page = capsys.readouterr().out
    assert [line.split()[0] for line in page.splitlines()[1:4]] == ["vx", "shoulder", "elbow"]
    ends = {len(line) for line in page.splitlines()[1:4]}
    assert len(ends) == 1  # numbers below one another
    assert max(map(len, page.splitlines())) <= 80


def test_many_columns_of_a_jacobian_fit_a_terminal(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("pinocchio")
    text = Path(ARM).read_text(encoding="utf-8").replace('"elbow"', f'"{"elbow_" * 9}"')
    (tmp_path / "arm.urdf").write_text(text, encoding="utf-8")
    assert main(["kinematics", str(tmp_path / "arm.urdf"), "--jacobian", "forearm"]) == 0
    lines = capsys.readouterr().out.splitlines()
    at = lines.index("elbow_" * 9)
    assert len(lines[at + 1].split()) == 6
    assert max(map(len, lines)) <= 80


def test_a_large_mass_matrix_is_printed_in_groups_of_columns(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    pytest.importorskip("pinocchio")
    names = [f"link_{number}" for number in range(11)]
    text = "".join(link(name, inertial(1, (1, 1, 1))) for name in names)
    text += "".join(joint(a, b, "continuous") for a, b in itertools.pairwise(names))
    (tmp_path / "r.urdf").write_text(whole_robot(text), encoding="utf-8")
    assert main(["kinematics", str(tmp_path / "r.urdf"), "--mass-matrix"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert max(map(len, lines)) <= 80
    (first, second) = (at for at, line in enumerate(lines) if line.startswith("columns "))
    assert [len(line.split()) for line in lines[second + 1 :]] == [11 - 6 + 1 - 1] * 10
    assert lines[second - 1].split()[0] == "link_10_joint"
    assert first == 1


def test_frames_of_several_roots_are_separate(capsys: pytest.CaptureFixture[str]) -> None:
    path = "-"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("sys.stdin", io.TextIOWrapper(io.BytesIO(TWO.encode())))
        assert main(["kinematics", path]) == 0
        lines = capsys.readouterr().out.splitlines()
    assert [line.split()[:3] for line in lines if line.startswith("frames")] == [
        ["frames", "in", "a,"],
        ["frames", "in", "c,"],
    ]
    assert [line.split()[0] for line in lines] == ["frames", "a", "b", "frames", "c"]


def test_frames_need_no_pinocchio_and_matrices_report_it(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setitem(sys.modules, "pinocchio", None)
    monkeypatch.delitem(sys.modules, "urdfkit.physics.dynamics.robot", raising=False)
    assert main(["kinematics", ARM]) == 0
    capsys.readouterr()
    assert main(["kinematics", ARM, "--mass-matrix"]) == 2
    assert install_command("dynamics") in capsys.readouterr().err


@pytest.mark.parametrize("words", [["--transform", "mount", "forarm"], ["--jacobian", "forarm"]])
def test_an_unknown_link_is_reported(words: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    if "--jacobian" in words:
        pytest.importorskip("pinocchio")
    assert main(["kinematics", ARM, *words]) == 2
    assert "did you mean 'forearm'?" in capsys.readouterr().err
