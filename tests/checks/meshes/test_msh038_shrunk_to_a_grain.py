"""MSH038: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from urdfkit.mesh.samples import box, stl

FILES = {"a.stl": SOUND, "mm.stl": stl(box((0, 0, 0), (1.5, 2, 3)))}


def test_a_part_of_30_cm(tmp_path: Path) -> None:
    shrunk = mesh("a.stl", more=' scale="0.001 0.001 0.001"')
    assert messages(tmp_path, "MSH038", link(shrunk), FILES) == [
        ("link 'arm': the collision mesh 'a.stl' is 0.3 mm long by its scale, and 0.3 m without it")
    ]


@pytest.mark.parametrize(
    "sound",
    [
        mesh("a.stl"),
        mesh("a.stl", more=' scale="0.01 0.01 0.01"'),  # 3 mm
        mesh("mm.stl", more=' scale="0.001 0.001 0.001"'),  # a pin
        mesh("a.stl", more=' scale="0 0 0"'),  # GEO005
    ],
)
def test_small_parts_and_other_scales(sound: str, tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH038", link(sound), FILES) == []
