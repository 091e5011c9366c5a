"""mesh generate: what is written and said, and the exit codes."""

from pathlib import Path

import pytest

pytest.importorskip("trimesh")

from tests.conftest import MODELS
from urdfkit.cli import main

REFERENCE = "package://gazebo_pkg/meshes/hokuyo.dae"


@pytest.fixture
def model(gazebo_pkg: Path) -> Path:
    return gazebo_pkg / "urdf" / "waking_robot_new.xacro"


def test_one_mesh(model: Path, capsys: pytest.CaptureFixture[str]) -> None:
    mesh = model.parents[1] / "meshes" / "hokuyo.dae"
    words = ["mesh", "generate", REFERENCE, "--model", str(model)]
    assert main([*words, "--dry-run"]) == 0
    assert not mesh.exists()
    assert capsys.readouterr().out.startswith(f"would write {mesh}\n  the file does not exist\n")
    assert main(words) == 0
    first = mesh.read_bytes()
    assert "fitted to the collision of link 'laser_frame'" in " ".join(
        capsys.readouterr().out.split()
    )
    assert main(words) == 2
    assert capsys.readouterr().err.endswith("is a valid mesh; use --force to replace it\n")
    assert main([*words, "--force"]) == 0
    assert mesh.read_bytes() == first, "the same mesh is the same file"


def test_all_missing_meshes(model: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", "generate", "--model", str(model)]) == 0
    assert main(["mesh", "generate", "--model", str(model)]) == 0
    assert capsys.readouterr().out.endswith("nothing is missing\n")


def test_a_failed_mesh_exits_with_1(capsys: pytest.CaptureFixture[str]) -> None:
    bad = str(MODELS / "bad" / "broken_meshes.urdf")
    assert main(["mesh", "generate", "--model", bad, "--dry-run"]) == 1
    assert "run 'git lfs pull'" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ([], "pass the robot with --model"),
        (["a.stl"], "pass the robot with --model"),
        (["a.stl", "b.stl"], "pass one mesh"),
        (["a.stl", "--part", "wheel", "--size", "1", "0", "1"], "every edge must be from 1e-06"),
        (["a.stl", "--part", "wheel", "--size", "1", "inf", "1"], "every edge must be from 1e-06"),
        (["--model", "MODEL", "--force"], "apply to one mesh"),
        (["no.stl", "--model", "MODEL"], "no shape of the robot references 'no.stl'"),
        (["--model", "no.urdf"], "no.urdf"),
        (["a.step", "--part", "wheel"], "unsupported suffix"),
    ],
)
def test_usage_errors(
    words: list[str], said: str, model: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    words = [str(model) if word == "MODEL" else word for word in words]
    assert main(["mesh", "generate", *words]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert said in captured.err


def test_mesh_alone_lists_its_commands(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh"]) == 0
    assert "generate" in capsys.readouterr().out
