from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import box, stl

CUBE = box((0, 0, 0), (1, 1, 1))


def test_100_008_triangles(tmp_path: Path) -> None:
    files = {"a.stl": stl(8334 * CUBE)}
    assert messages(tmp_path, "MSH020", link(mesh("a.stl", "visual")), files) == [
        (
            "link 'arm': the visual mesh 'a.stl' has 100008 triangles, more than the 100000 that "
            "are drawn easily"
        )
    ]
    both = link(mesh("a.stl", "visual"), mesh("a.stl"))
    assert messages(tmp_path, "MSH020", both, files) == []  # MSH019 tells it


def test_fewer(tmp_path: Path) -> None:
    files = {"a.stl": stl(8333 * CUBE)}
    assert messages(tmp_path, "MSH020", link(mesh("a.stl", "visual")), files) == []
