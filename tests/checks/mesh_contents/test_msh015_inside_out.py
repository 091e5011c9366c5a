from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from tests.naming import naming
from urdfkit.core.spatial import Vector
from urdfkit.mesh.samples import BOX, box, stl


def inside_out(low: Vector, high: Vector) -> list[list[Vector]]:
    return box(low, high, (face[::-1] for face in BOX))


WHO = ("arm", "collision", "a.stl", "inside out")


def test_all_of_it(tmp_path: Path) -> None:
    files = {"a.stl": stl(inside_out((0, 0, 0), (1, 1, 1)))}
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), files) == [naming(*WHO, "triangles")]


@pytest.mark.parametrize(("size", "is_reported"), [(1.0, True), (0.3, True), (0.2, False)])
def test_a_piece_that_matters(tmp_path: Path, size: float, is_reported: bool) -> None:
    """Of 1 % of the volume: a cube of 0.2 beside one of 1 has less."""
    pieces = [*box((0, 0, 0), (1, 1, 1)), *inside_out((2, 0, 0), (2 + size, size, size))]
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": stl(pieces)}) == (
        [naming(*WHO, "1", "2", "pieces")] if is_reported else []
    )


def test_a_hollow(tmp_path: Path) -> None:
    pieces = [*box((0, 0, 0), (3, 3, 3)), *inside_out((1, 1, 1), (2, 2, 2))]
    assert messages(tmp_path, "MSH015", link(mesh("a.stl")), {"a.stl": stl(pieces)}) == []


def test_a_mirrored_mesh(tmp_path: Path) -> None:
    """Programs flip its triangles, or should: the file is right."""
    part = mesh("a.stl", more=' scale="-1 1 1"')
    assert messages(tmp_path, "MSH015", link(part), {"a.stl": SOUND}) == []
