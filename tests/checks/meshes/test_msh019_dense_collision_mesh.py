from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import box, stl

CUBE = box((0, 0, 0), (1, 1, 1))
MANY = stl(1667 * CUBE)


def test_20_004_triangles(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH019", link(mesh("a.stl")), {"a.stl": MANY}) == [
        (
            "link 'arm': the collision mesh 'a.stl' has 20,004 triangles; more than 20,000 make "
            "collision checking slow"
        )
    ]


def test_mujoco_refuses_it(tmp_path: Path) -> None:
    (found,) = messages(tmp_path, "MSH019", link(mesh("a.stl")), {"a.stl": stl(16_667 * CUBE)})
    assert found.endswith("slow, and MuJoCo rejects more than 200,000")


def test_fewer_or_only_seen(tmp_path: Path) -> None:
    files = {"a.stl": MANY, "b.stl": stl(1666 * CUBE)}
    robot = link(mesh("a.stl", "visual"), mesh("b.stl"))
    assert messages(tmp_path, "MSH019", robot, files) == []
