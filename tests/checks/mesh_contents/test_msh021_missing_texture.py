from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")
pytest.importorskip("manifold3d")

from tests.meshed import link, mesh, messages
from tests.naming import naming
from urdfkit.mesh.samples import collada

WOOD = collada(effect='<diffuse><texture texture="image" texcoord="UV"/></diffuse>')


def test_an_image_of_collada(tmp_path: Path) -> None:
    robot = link(mesh("meshes/a.dae", "visual"))
    files = {"meshes/a.dae": WOOD}
    assert messages(tmp_path, "MSH021", robot, files) == [
        naming("arm", "visual", "meshes/a.dae", "wood.png")
    ]
    assert len(messages(tmp_path, "MSH021", robot, {"wood.png": b"elsewhere"})) == 1
    assert messages(tmp_path, "MSH021", robot, {"meshes/wood.png": b"beside"}) == []


def test_a_collision(tmp_path: Path) -> None:
    files = {"a.dae": WOOD}
    assert messages(tmp_path, "MSH021", link(mesh("a.dae")), files) == []
    both = link(mesh("a.dae"), mesh("a.dae", "visual"))
    (message,) = messages(tmp_path, "MSH021", both, files)
    assert message == naming("arm", "visual", "a.dae", "wood.png")


def test_an_image_that_no_surface_uses(tmp_path: Path) -> None:
    assert messages(tmp_path, "MSH021", link(mesh("a.dae")), {"a.dae": collada()}) == []


def test_images_of_an_obj(tmp_path: Path) -> None:
    files = {
        "a.obj": b"mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n",
        "a.mtl": b"newmtl m\nmap_Kd one.png\nnewmtl n\nmap_Kd two.png\n",
    }
    assert messages(tmp_path, "MSH021", link(mesh("a.obj", "visual")), files) == [
        naming("arm", "visual", "a.obj", "one.png", "1")
    ]


OBJ = b"mtllib looks/a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n"


def test_the_material_file_is_searched_next_to_the_mesh(tmp_path: Path) -> None:
    robot = link(mesh("meshes/a.obj", "visual"))
    files = {"meshes/a.obj": OBJ}
    assert messages(tmp_path, "MSH021", robot, files) == [
        naming("arm", "visual", "meshes/a.obj", "looks/a.mtl")
    ]
    for directory, number in (("", 1), ("meshes/", 0)):
        there = tmp_path / f"{number}"
        there.mkdir()
        more = {f"{directory}looks/a.mtl": b"newmtl m\n"}
        assert len(messages(there, "MSH021", robot, files | more)) == number


def test_a_material_of_urdf_takes_its_place(tmp_path: Path) -> None:
    coloured = mesh("a.obj", "visual").replace(
        "</visual>", '<material name="red"><color rgba="1 0 0 1"/></material></visual>'
    )
    assert messages(tmp_path, "MSH021", link(coloured), {"a.obj": OBJ}) == []


def test_collisions_and_an_obj_without_colours(tmp_path: Path) -> None:
    plain = OBJ.partition(b"\n")[2]
    assert messages(tmp_path, "MSH021", link(mesh("a.obj")), {"a.obj": OBJ}) == []
    assert messages(tmp_path, "MSH021", link(mesh("b.obj", "visual")), {"b.obj": plain}) == []


def test_a_file_that_is_a_collision_too(tmp_path: Path) -> None:
    for number, parts in enumerate((("collision", "visual"), ("visual", "collision"))):
        robot = link(*(mesh("a.obj", role) for role in parts))
        (tmp_path / f"{number}").mkdir()
        (message,) = messages(tmp_path / f"{number}", "MSH021", robot, {"a.obj": OBJ})
        assert message == naming("arm", "visual", "a.obj", "looks/a.mtl")
