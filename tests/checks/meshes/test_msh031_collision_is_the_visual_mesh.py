from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import box, stl

CUBE = box((0, 0, 0), (1, 1, 1))


@pytest.mark.parametrize(
    ("cubes", "is_reported"), [(416, False), (417, True), (1666, True), (1667, False)]
)
def test_5000_to_20_000_triangles(tmp_path: Path, cubes: int, is_reported: bool) -> None:
    """More are told by MSH019."""
    robot = link(mesh("a.stl", "visual"), mesh("a.stl"))
    found = messages(tmp_path, "MSH031", robot, {"a.stl": stl(cubes * CUBE)})
    message = (
        f"link 'arm': the collision mesh 'a.stl' is the visual mesh ({12 * cubes:,} triangles, "
        "more than 5,000); consider a simpler one"
    )
    assert found == [message] * is_reported


def test_another_file_or_another_link(tmp_path: Path) -> None:
    files = {"a.stl": stl(500 * CUBE), "b.stl": stl(501 * CUBE)}
    two = link(mesh("a.stl", "visual"), mesh("b.stl")) + link(mesh("a.stl"), name="b")
    assert messages(tmp_path, "MSH031", two, files) == []
