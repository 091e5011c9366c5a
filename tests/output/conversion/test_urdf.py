"""URDF: what was written is the robot, and all files are with it."""

from pathlib import Path

import pytest

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.output.conversion.converted import of_corpus, results
from tests.own_robots import ROVER, own_robots
from urdfkit import convert, read

pytest.importorskip("trimesh")

from urdfkit.output.conversion.urdf import prove


@own_robots
def test_robots_of_the_project(path: Path, tmp_path: Path) -> None:
    found = convert(path, tmp_path / "o", to="urdf")
    assert found.proof.holds
    assert {one.result.value for one in found.entries} <= {"kept", "approximated"}
    assert (tmp_path / "o" / found.file).is_file()


@needs_corpus
@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_robots_of_the_corpus(entry: CorpusRobot, tmp_path: Path) -> None:
    of_corpus(entry, tmp_path / "o", "urdf")


def test_results_of_the_parts(tmp_path: Path) -> None:
    found = convert(ROVER, tmp_path / "o", to="urdf")
    parts = results(found)
    mesh = "link/left_wheel/visual/geometry/mesh@filename"
    assert parts[mesh] == "kept: copied as meshes/wheel.stl"
    assert parts["link/left_wheel@name"] == "kept: as written"
    outside = [part for part, result in parts.items() if "is not copied" in result]
    assert len(outside) == 1
    assert outside[0].endswith("/parameters")


@pytest.mark.parametrize(
    ("old", "new"),
    [(b'radius="0.1"', b'radius="0.2"'), (b"wheel.stl", b"other.stl"), (b"orange", b"red")],
)
def test_the_proof_fails_for_a_wrong_file(old: bytes, new: bytes, tmp_path: Path) -> None:
    robot = read(ROVER)
    path = tmp_path / "o" / convert(robot, tmp_path / "o", to="urdf").file
    assert prove(read(path), robot).holds
    text = path.read_bytes()
    assert old in text
    path.write_bytes(text.replace(old, new, 1))
    assert not prove(read(path), robot).holds
