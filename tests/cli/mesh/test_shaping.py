"""mesh simplify, hull and decompose: what is said, what is written, the exit codes."""

from pathlib import Path

import pytest

pytest.importorskip("trimesh")

import trimesh

from tests.mesh.shapes_made import as_mesh, as_part
from urdfkit.cli import main
from urdfkit.mesh.geometry import Mesh
from urdfkit.mesh.writers import write

pytestmark = pytest.mark.usefixtures("rough_meshes")


@pytest.fixture
def ring(tmp_path: Path) -> Path:
    write(as_mesh(trimesh.creation.torus(1.0, 0.3, 24, 12)), tmp_path / "ring.stl")
    return tmp_path / "ring.stl"


def test_simplify(ring: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = ring.with_name("out.dae")
    assert main(["mesh", "simplify", str(ring), "--triangles", "200", "-o", str(out)]) == 0
    assert len(trimesh.load_mesh(out).faces) <= 200
    assert "% of the diagonal" in capsys.readouterr().out
    assert main(["mesh", "simplify", str(ring), "--error", "0.05"]) == 0
    assert "nothing written" in capsys.readouterr().out
    assert main(["mesh", "simplify", str(ring), "--error", "0.05", "--write"]) == 0
    assert trimesh.load_mesh(ring).volume == pytest.approx(1.7, rel=0.1)


def test_hull(ring: Path) -> None:
    out = ring.with_name("hull.stl")
    assert main(["mesh", "hull", str(ring), "-o", str(out)]) == 0
    assert trimesh.load_mesh(out).is_convex
    assert main(["mesh", "hull", str(ring), "-o", str(out)]) == 2
    assert main(["mesh", "hull", str(ring), "-o", str(out), "--force"]) == 0


@pytest.fixture
def angle(tmp_path: Path) -> Path:
    """Two boards, which two convex pieces are enough for."""
    boards = [trimesh.creation.box((1, 0.2, 0.2)), trimesh.creation.box((0.2, 0.2, 1))]
    boards[1].apply_translation((-0.6, 0, 0.4))
    write(Mesh(tuple(map(as_part, boards))), tmp_path / "angle.stl")
    return tmp_path / "angle.stl"


def test_decompose(angle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = angle.with_name("piece.stl")
    words = ["mesh", "decompose", str(angle), "--most", "2", "-o", str(out)]
    assert main([*words, "--split"]) == 0
    page = capsys.readouterr().out
    assert "piece 2:" in page
    assert "its convex hull sticks out by " in page  # which one piece would do
    assert all(trimesh.load_mesh(angle.with_name(f"piece_{n}.stl")).is_convex for n in (1, 2))
    assert not out.exists()
    assert main(words[:-2]) == 0
    assert capsys.readouterr().out.endswith("nothing written; use --output OUT\n")
    assert main(words) == 0
    assert out.exists()


def test_pieces_are_written_all_or_none(angle: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["mesh", "decompose", str(angle), "--most", "2", "-o", str(angle), "--split"]
    assert main(words) == 0  # nothing is written to the name itself
    angle.with_name("angle_1.stl").unlink()
    assert main(words) == 2
    assert "angle_2.stl is a valid mesh" in capsys.readouterr().err
    assert not angle.with_name("angle_1.stl").exists()


@pytest.mark.parametrize(
    "words",
    [
        ["simplify", "FILE"],
        ["simplify", "FILE", "--triangles", "9", "--error", "1"],
        ["simplify", "FILE", "--triangles", "3"],
        ["simplify", "FILE", "--error", "0"],
        ["simplify", "no.stl", "--error", "1"],
        ["decompose", "FILE", "--most", "0"],
        ["decompose", "FILE", "--split"],
        ["hull", "no.stl"],
        ["hull", "FILE", "-o", "a.step"],
    ],
)
def test_usage_errors(words: list[str], ring: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", *(str(ring) if word == "FILE" else word for word in words)]) == 2
    captured = capsys.readouterr()
    assert captured.out == ""
    assert captured.err.startswith("error: ")
