from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import collada

LINES = '<lines count="1"><input semantic="VERTEX" source="#corners" offset="0"/><p>0 1</p></lines>'


def test_lines(tmp_path: Path) -> None:
    files = {"a.dae": collada(more=LINES), "b.dae": collada()}
    robot = link(mesh("a.dae", "visual"), mesh("b.dae", "visual"))
    assert messages(tmp_path, "MSH029", robot, files) == [
        "link 'arm': the visual mesh 'a.dae' also holds 1 line set; only triangles count"
    ]


def test_cameras_and_lights(tmp_path: Path) -> None:
    text = collada().replace(
        b"<node>", b'<node><instance_camera url="#a"/><instance_light url="#b"/>'
    )
    (found,) = messages(tmp_path, "MSH029", link(mesh("a.dae")), {"a.dae": text})
    assert "also holds 1 camera, 1 light; only" in found
