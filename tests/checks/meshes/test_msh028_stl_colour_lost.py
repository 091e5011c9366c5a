from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import box, stl


def test_coloured_triangles(tmp_path: Path) -> None:
    coloured = stl(box((0, 0, 0), (1, 1, 1)), colour=0x8000)
    other = stl(box((0, 0, 0), (1, 1, 1)), colour=0x7FFF)  # the mark of a colour is not set
    robot = link(mesh("a.stl", "visual"), mesh("b.stl", "visual"), mesh("c.stl"))
    files = {"a.stl": coloured, "b.stl": other, "c.stl": SOUND}
    assert messages(tmp_path, "MSH028", robot, files) == [
        "link 'arm': the visual mesh 'a.stl' holds colours of 12 triangles, which no reader shows"
    ]
