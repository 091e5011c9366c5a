"""MSH037: see the rule."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages

OBJ = b"mtllib looks/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"


def test_the_file_is_searched_beside_the_mesh(tmp_path: Path) -> None:
    robot = link(mesh("meshes/a.obj", "visual"))
    files = {"meshes/a.obj": OBJ}
    assert messages(tmp_path, "MSH037", robot, files) == [
        (
            "link 'arm': the visual mesh 'meshes/a.obj' has its colours in 'looks/a.mtl', which "
            "is not there"
        )
    ]
    for folder, reported in (("", 1), ("meshes/", 0)):
        there = tmp_path / f"{reported}"
        there.mkdir()
        more = {f"{folder}looks/a.mtl": b"newmtl m\n"}
        assert len(messages(there, "MSH037", robot, files | more)) == reported


def test_a_material_of_urdf_takes_its_place(tmp_path: Path) -> None:
    coloured = mesh("a.obj", "visual").replace(
        "</visual>", '<material name="red"><color rgba="1 0 0 1"/></material></visual>'
    )
    assert messages(tmp_path, "MSH037", link(coloured), {"a.obj": OBJ}) == []


def test_nobody_sees_collisions_and_not_every_obj_has_colours(tmp_path: Path) -> None:
    plain = OBJ.partition(b"\n")[2]
    assert messages(tmp_path, "MSH037", link(mesh("a.obj")), {"a.obj": OBJ}) == []
    assert messages(tmp_path, "MSH037", link(mesh("b.obj", "visual")), {"b.obj": plain}) == []


def test_a_file_that_is_a_collision_too(tmp_path: Path) -> None:
    for number, parts in enumerate((("collision", "visual"), ("visual", "collision"))):
        robot = link(*(mesh("a.obj", role) for role in parts))
        (tmp_path / f"{number}").mkdir()
        (message,) = messages(tmp_path / f"{number}", "MSH037", robot, {"a.obj": OBJ})
        assert "the visual mesh 'a.obj'" in message
