from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from urdfkit.mesh.samples import collada

WOOD = collada(look='<diffuse><texture texture="image" texcoord="UV"/></diffuse>')


def test_an_image_of_collada(tmp_path: Path) -> None:
    robot = link(mesh("meshes/a.dae", "visual"))
    files = {"meshes/a.dae": WOOD}
    assert messages(tmp_path, "MSH021", robot, files) == [
        "link 'arm': the visual mesh 'meshes/a.dae' uses the image 'wood.png', which is not there"
    ]
    assert len(messages(tmp_path, "MSH021", robot, {"wood.png": b"elsewhere"})) == 1
    assert messages(tmp_path, "MSH021", robot, {"meshes/wood.png": b"beside"}) == []


def test_nobody_sees_a_collision(tmp_path: Path) -> None:
    files = {"a.dae": WOOD}
    assert messages(tmp_path, "MSH021", link(mesh("a.dae")), files) == []
    both = link(mesh("a.dae"), mesh("a.dae", "visual"))
    (message,) = messages(tmp_path, "MSH021", both, files)
    assert message.startswith("link 'arm': the visual mesh")


def test_an_image_that_no_surface_uses(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH021", link(mesh("a.dae")), {"a.dae": collada()}) == []


def test_images_of_an_obj(tmp_path: Path) -> None:
    files = {
        "a.obj": b"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n",
        "a.mtl": b"newmtl m\nmap_Kd one.png\nnewmtl n\nmap_Kd two.png\n",
    }
    assert messages(tmp_path, "MSH021", link(mesh("a.obj", "visual")), files) == [
        (
            "link 'arm': the visual mesh 'a.obj' uses the image 'one.png' and 1 more, "
            "which is not there"
        )
    ]
