from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import SOUND, link, mesh, messages
from tests.naming import naming
from urdfkit.mesh.samples import box, collada, stl

LINES = '<lines count="1"><input semantic="VERTEX" source="#corners" offset="0"/><p>0 1</p></lines>'


def test_lines(tmp_path: Path) -> None:
    files = {"a.dae": collada(more=LINES), "b.dae": collada()}
    robot = link(mesh("a.dae", "visual"), mesh("b.dae", "visual"))
    assert messages(tmp_path, "MSH029", robot, files) == [naming("arm", "visual", "a.dae", "1")]


def test_cameras_and_lights(tmp_path: Path) -> None:
    text = collada().replace(
        b"<node>", b'<node><instance_camera url="#a"/><instance_light url="#b"/>'
    )
    (found,) = messages(tmp_path, "MSH029", link(mesh("a.dae")), {"a.dae": text})
    assert found == naming("arm", "collision", "a.dae", "1", "1")


def test_coloured_triangles(tmp_path: Path) -> None:
    coloured = stl(box((0, 0, 0), (1, 1, 1)), colour=0x8000)
    other = stl(box((0, 0, 0), (1, 1, 1)), colour=0x7FFF)  # the mark of a colour is not set
    robot = link(mesh("a.stl", "visual"), mesh("b.stl", "visual"), mesh("c.stl"))
    files = {"a.stl": coloured, "b.stl": other, "c.stl": SOUND}
    assert messages(tmp_path, "MSH029", robot, files) == [
        naming("arm", "visual", "a.stl", "12 triangles")
    ]
