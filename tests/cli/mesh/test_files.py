"""mesh info, convert and repair: what is said, what is written, the exit codes."""

import json
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("trimesh")

import numpy as np
import trimesh

from tests.conftest import MODELS
from tests.mesh.shapes_made import as_mesh
from urdfkit.cli import main
from urdfkit.mesh.writers import write

BAD = MODELS / "bad" / "meshes"


@pytest.fixture
def ball(tmp_path: Path) -> Path:
    write(as_mesh(trimesh.creation.icosphere(2, 0.1)), tmp_path / "ball.stl")
    return tmp_path / "ball.stl"


@pytest.fixture
def holed(tmp_path: Path) -> Path:
    shape = trimesh.creation.icosphere(2, 0.1)
    shape.update_faces(np.arange(len(shape.faces)) > 2)
    write(as_mesh(shape), tmp_path / "holed.stl")
    return tmp_path / "holed.stl"


def test_info(ball: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["mesh", "info", str(ball), str(BAD / "truncated.stl")]) == 0
    text = capsys.readouterr().out
    assert "closed, a solid" in text
    assert f"{trimesh.load_mesh(ball).volume * 1e6:.6g} cm³" in text
    assert "declares 12 triangles and contains 6; 6 of 12 triangles are readable" in text
    assert all(len(line) <= 80 for line in text.splitlines()[1:])
    assert main(["mesh", "info", "--format", "json", str(ball)]) == 0
    (found,) = json.loads(capsys.readouterr().out)["meshes"]
    assert found["solid"] is True
    assert found["faces"] == 320
    assert found["high"] == pytest.approx([0.1] * 3)
    assert main(["mesh", "info", str(BAD / "bot.dae")]) == 2


def test_convert(ball: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = ball.with_suffix(".dae")
    assert main(["mesh", "convert", str(ball), "-o", str(out), "--scale", "2"]) == 0
    assert trimesh.load_mesh(out).bounds[1] == pytest.approx([0.2] * 3)
    assert main(["mesh", "convert", str(ball), "-o", str(out)]) == 2
    assert "use --force to replace it" in capsys.readouterr().err
    assert main(["mesh", "convert", str(ball), "-o", str(out), "--force"]) == 0
    assert main(["mesh", "convert", str(out), "-o", str(ball), "--force"]) == 0
    assert "this format cannot store: materials" in capsys.readouterr().out
    assert main(["mesh", "convert", str(ball), "-o", str(out), "--scale", "0"]) == 2


def test_convert_applies_the_unit_and_option_upright(tmp_path: Path) -> None:
    text = (BAD.parents[1] / "gazebo_pkg").exists()
    assert text
    source = tmp_path / "inch.dae"
    write(as_mesh(trimesh.creation.box((1, 2, 3))), source)
    data = source.read_bytes().replace(b'meter="1"', b'meter="0.0254"')
    source.write_bytes(data.replace(b"Z_UP", b"Y_UP"))
    for words, size in (([], (1, 2, 3)), (["--upright"], (1, 3, 2))):
        out = tmp_path / "out.stl"
        assert main(["mesh", "convert", str(source), "-o", str(out), "--force", *words]) == 0
        edges = np.ptp(trimesh.load_mesh(out).vertices, axis=0)
        assert edges == pytest.approx(np.array(size) * 0.0254)


def test_repair(holed: Path, capsys: pytest.CaptureFixture[str]) -> None:
    before = holed.read_bytes()
    assert main(["mesh", "repair", str(holed)]) == 1
    text = capsys.readouterr().out
    assert text.startswith("found ")
    assert "closed holes" in text
    assert text.endswith("nothing written; use --output OUT or --write\n")
    assert holed.read_bytes() == before
    assert main(["mesh", "repair", str(holed), "--keep-holes"]) == 1
    assert main(["mesh", "repair", str(holed), "--write", "-o", "x.stl"]) == 2
    assert main(["mesh", "repair", str(holed), "--write"]) == 0
    assert trimesh.load_mesh(holed).is_volume
    assert main(["mesh", "repair", str(holed)]) == 0
    assert capsys.readouterr().out.endswith("the triangles are the surface of a solid\n")


def test_repair_of_a_broken_file(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    out = tmp_path / "cube.stl"
    assert main(["mesh", "repair", str(BAD / "truncated.stl"), "-o", str(out)]) == 0
    assert trimesh.load_mesh(out).volume == pytest.approx(0.05**3)
    assert "the file declares 12 triangles and contains 6" in capsys.readouterr().out
    assert main(["mesh", "repair", str(BAD / "empty.dae")]) == 2
