from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from tests.naming import naming
from urdfkit.core.spatial import Vector
from urdfkit.mesh.samples import box, stl

CUBE = box((0, 0, 0), (1, 1, 1))
NEEDLE: list[Vector] = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.5, 0.0, 0.0)]
POINT: list[Vector] = [(0.0, 0.0, 0.0)] * 3


@pytest.mark.parametrize(
    ("bad", "words"),
    [([NEEDLE], ["1", "13 triangles"]), ([NEEDLE, POINT], ["2", "14 triangles"])],
)
def test_triangles_without_area(tmp_path: Path, bad: list[list[Vector]], words: list[str]) -> None:
    files = {"a.stl": stl([*CUBE, *bad])}
    assert messages(tmp_path, "MSH017", link(mesh("a.stl")), files) == [
        naming("arm", "collision", "a.stl", *words)
    ]


@pytest.mark.parametrize(("sound", "is_reported"), [(8, True), (9, False)])
def test_one_percent_of_a_visual(tmp_path: Path, sound: int, is_reported: bool) -> None:
    files = {"a.stl": stl([*sound * CUBE, NEEDLE])}
    found = messages(tmp_path, "MSH017", link(mesh("a.stl", "visual")), files)
    assert bool(found) is is_reported


def test_thin_is_not_flat(tmp_path: Path) -> None:
    files = {"a.stl": stl(box((0, 0, 0), (1, 1, 1e-5)))}
    assert messages(tmp_path, "MSH017", link(mesh("a.stl")), files) == []
