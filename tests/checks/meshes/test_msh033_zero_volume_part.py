from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import BOX, box, stl

FLAT = stl(box((0, 0, 0), (1, 1, 1), BOX[:2]))


def test_a_square(tmp_path: Path) -> None:
    robot = link(mesh("a.stl"), mesh("b.stl"))
    assert messages(tmp_path, "MSH033", robot, {"a.stl": FLAT, "b.stl": SOUND}) == [
        "link 'arm': the collision mesh 'a.stl' is flat: it has 0 x 1 x 1 m"
    ]


def test_a_label_may_be_flat(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH033", link(mesh("a.stl", "visual")), {"a.stl": FLAT}) == []


def test_thin_is_not_flat(tmp_path: Path) -> None:
    thin = stl(box((0, 0, 0), (1, 1, 1e-4)))
    assert messages(tmp_path, "MSH033", link(mesh("a.stl")), {"a.stl": thin}) == []
