"""Meshes, materials and collision shapes in MJCF."""

import io
import re
from pathlib import Path

import pytest

from urdfkit import convert, read
from urdfkit.errors import UrdfkitError

mujoco = pytest.importorskip("mujoco")
np = pytest.importorskip("numpy")
Image = pytest.importorskip("PIL.Image")
from tests.output.conversion.test_mjcf import INERTIAL, LIMIT, arm, loaded

#: Two triangles with an image, a part without, which is red, and a triangle that is blue.
OBJ = """\
mtllib m.mtl
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
v 1 1 0
v 1 1 1
vt 0 0
vt 1 0
vt 0 1
usemtl image
f 1/1 2/2 3/3
f 1/1 2/2 4/3
f 2/1 5/2 3/3
usemtl red
f 3 5 6
f 2 5 6
f 1 5 6
usemtl blue
f 1 2 6
"""
MTL = "newmtl image\nmap_Kd {image}\nnewmtl red\nKd 1 0 0\nd 0.5\nnewmtl blue\nKd 0 0 1\n"


def image(kind: str) -> bytes:
    """An image of 2 by 2 pixels: the upper left one is red, the others are black."""
    file = io.BytesIO()
    pixels = np.zeros((2, 2, 3), dtype=np.uint8)
    pixels[0, 0, 0] = 255
    Image.fromarray(pixels).save(file, kind)
    return file.getvalue()


def meshed(directory: Path, more: str = "", *, kind: str = "png") -> Path:
    """A robot with the mesh above as a visual."""
    (directory / f"i.{kind}").write_bytes(image(kind))
    (directory / "m.obj").write_text(OBJ)
    (directory / "m.mtl").write_text(MTL.format(image=f"i.{kind}"))
    shape = '<geometry><mesh filename="m.obj" scale="1 1 2"/></geometry>'
    tip = f"{INERTIAL}<visual>{shape}{more}</visual><collision>{shape}</collision>"
    path = directory / "r.urdf"
    path.write_bytes(arm(LIMIT, tip=tip).data)
    return path


@pytest.mark.parametrize("kind", ["png", "bmp"])
def test_each_material_of_a_mesh_is_a_geom(kind: str, tmp_path: Path) -> None:
    model, parts = loaded(meshed(tmp_path, kind=kind), tmp_path / "o")
    seen = [number for number in range(model.ngeom) if not model.geom_contype[number]]
    assert len(seen) == 2, "a single triangle is no mesh for MuJoCo"
    assert model.geom_matid[seen].tolist() == [0, -1]
    assert model.geom_rgba[seen[1]].tolist() == [1, 0, 0, 0.5]
    assert model.tex_data[:12].tolist() == [255] + [0] * 11
    assert sorted(path.name for path in (tmp_path / "o").rglob("*.*")) == [
        "arm.xml",
        "conversion.json",
        "i.png",
        "m.obj",
        "m_material_1.obj",
        "m_material_2.obj",
    ]
    at = "link/tip/visual/geometry/mesh"
    assert parts[at] == "kept: visual geom for each of its 2 materials"


def test_a_material_of_the_robot_replaces_mesh_materials(tmp_path: Path) -> None:
    more = '<material name="g"><color rgba="0 1 0 1"/></material>'
    model, parts = loaded(meshed(tmp_path, more), tmp_path / "o")
    assert model.geom_contype.tolist() == [0, 1]
    assert model.geom_rgba[0].tolist() == [0, 1, 0, 1]
    assert parts["link/tip/visual/material/g/color"] == "kept: rgba of the geom"


def test_a_texture_of_the_robot(tmp_path: Path) -> None:
    more = '<material name="i"><texture filename="i.png"/></material>'
    path = meshed(tmp_path, more)
    whole = OBJ.replace("f 3 5 6", "f 3/1 5/2 6/3").split("f 2 5 6")[0]
    (tmp_path / "m.obj").write_text(whole)
    model, parts = loaded(path, tmp_path / "o")
    assert model.geom_matid[0] == 0
    assert parts["link/tip/visual/material/i/texture@filename"] == "kept: texture"
    (tmp_path / "i.png").write_bytes(b"no image")
    model, parts = loaded(path, tmp_path / "p")
    assert model.ntex == 0
    assert parts["link/tip/visual/material/i/texture"] == "lost: the image cannot be read"


def test_the_gazebo_material_of_a_link(tmp_path: Path) -> None:
    visual = f'{INERTIAL}<visual><geometry><sphere radius="1"/></geometry></visual>'
    tag = '<gazebo reference="tip"><material>Gazebo/Red</material></gazebo>'
    model, parts = loaded(arm(LIMIT, tip=visual, more=tag), tmp_path / "o")
    assert model.geom_rgba[0].tolist() == [1, 0, 0, 1]
    assert parts["gazebo/tip/material"] == "kept: rgba of the geom"


@pytest.mark.parametrize("collision", ["hull", "decompose"])
def test_collision_meshes(collision: str, tmp_path: Path) -> None:
    model, parts = loaded(meshed(tmp_path), tmp_path / "o", collision=collision)
    collides = np.flatnonzero(model.geom_contype)
    assert (len(collides) > 1) == (collision == "decompose")
    assert (model.geom_type[collides] == mujoco.mjtGeom.mjGEOM_MESH).all()
    assert parts["link/tip/collision/geometry/mesh"].endswith("mm outside the mesh")


def test_a_box_shaped_mesh_collides_as_a_box(tmp_path: Path) -> None:
    path = meshed(tmp_path)
    corners = [(x, y, z) for x in (0, 1) for y in (0, 2) for z in (0, 3)]
    quads = ("1 3 4 2", "5 6 8 7", "1 2 6 5", "3 7 8 4", "1 5 7 3", "2 4 8 6")
    lines = [f"v {x} {y} {z}" for x, y, z in corners] + [f"f {quad}" for quad in quads]
    (tmp_path / "m.obj").write_text("\n".join(lines))
    model, parts = loaded(path, tmp_path / "o", collision="primitives")
    box = int(np.flatnonzero(model.geom_contype)[0])
    assert model.geom_type[box] == mujoco.mjtGeom.mjGEOM_BOX
    assert sorted(model.geom_size[box]) == pytest.approx([0.5, 1, 3], abs=1e-6)
    assert model.geom_pos[box] == pytest.approx([0.5, 1, 3], abs=1e-6)
    assert parts["link/tip/collision/geometry/mesh"].startswith("approximated: box, up to ")


def test_no_other_file_is_written(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """MuJoCo writes a log of its warnings into the current directory."""
    monkeypatch.chdir(tmp_path)
    loaded(meshed(tmp_path), tmp_path / "o")
    assert not (tmp_path / "MUJOCO_LOG.TXT").exists()


def test_a_flat_mesh_collides_as_a_plate(tmp_path: Path) -> None:
    corners = ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0))
    lines = [f"v {x} {y} {z}" for x, y, z in corners]
    (tmp_path / "flat.obj").write_text("\n".join([*lines, "f 1 2 3", "f 1 3 4"]))
    shape = '<geometry><mesh filename="flat.obj" scale="2 1 1"/></geometry>'
    tip = f"{INERTIAL}<collision>{shape}</collision>"
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, parts = loaded(file, tmp_path / "o")
    assert sorted(model.geom_aabb[0, 3:].round(6)) == [0.0005, 0.5, 1]
    note = parts["link/tip/collision/geometry/mesh"]
    assert note == "approximated: its convex hull, 1 mm thick, as the mesh is flat"


def test_a_mesh_that_mujoco_rejects_is_named_at_its_line(tmp_path: Path) -> None:
    shape = pyramid(tmp_path / "tiny.obj").replace("<mesh", '\n<mesh scale="1e-6 1e-6 1e-6"')
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=f"{INERTIAL}<collision>{shape}</collision>").data)
    with pytest.raises(UrdfkitError, match=r"arm\.urdf:4:1: .*too small.*; correct its scale"):
        convert(read(file), tmp_path / "o")


def pyramid(path: Path, height: float = 1, faces: int = 4) -> str:
    """A mesh file; its element."""
    corners = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, height))
    sides = ["f 1 3 2", "f 1 2 4", "f 1 4 3", "f 2 3 4"]
    lines = [*(f"v {x} {y} {z}" for x, y, z in corners), *sides[:faces]]
    path.write_text("\n".join(lines))
    return f'<geometry><mesh filename="{path.name}"/></geometry>'


def test_meshes_with_equal_names(tmp_path: Path) -> None:
    """A mesh that is a visual and a collision is two; the second one was called like a file."""
    first, second = (
        pyramid(tmp_path / name, 1 + at) for at, name in enumerate(("p.obj", "p_2.obj"))
    )
    tip = f"{INERTIAL}<visual>{first}</visual>" + "".join(
        f"<collision>{one}</collision>" for one in (first, second)
    )
    file = tmp_path / "arm.urdf"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, _ = loaded(file, tmp_path / "o")
    assert [model.mesh(number).name for number in range(3)] == ["p", "p_2", "p_2_2"]


def test_a_visual_of_one_triangle_is_lost(tmp_path: Path) -> None:
    shape = pyramid(tmp_path / "t.obj", faces=1)
    file = tmp_path / "arm.urdf"
    tip = f"{INERTIAL}<visual>{shape}</visual><collision>{shape}</collision>"
    file.write_bytes(arm(LIMIT, tip=tip).data)
    model, parts = loaded(file, tmp_path / "o")
    assert model.ngeom == 1
    why = "lost: MuJoCo rejects meshes with fewer than 4 vertices"
    assert parts["link/tip/visual"] == why


def test_a_visual_without_size_is_lost(tmp_path: Path) -> None:
    tip = INERTIAL + '<visual><geometry><box size="0 0 0"/></geometry></visual>'
    model, parts = loaded(arm(LIMIT, tip=tip), tmp_path / "o")
    assert model.ngeom == 0
    assert parts["link/tip/visual"] == "lost: <box> of link 'tip' has no size above 0"


def test_distance_of_a_convex_hull_from_its_mesh(tmp_path: Path) -> None:
    """A corner of three plates, and a tetrahedron."""
    corner = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 1 3 4\n"
    (tmp_path / "corner.obj").write_text(corner)
    (tmp_path / "tetrahedron.obj").write_text(f"{corner}f 2 3 4\n")
    collisions = "".join(
        f'<collision><geometry><mesh filename="{name}.obj"/></geometry></collision>'
        for name in ("corner", "tetrahedron")
    )
    (tmp_path / "arm.urdf").write_bytes(arm(LIMIT, tip=INERTIAL + collisions).data)
    _, parts = loaded(tmp_path / "arm.urdf", tmp_path / "o")
    note = parts["link/tip/collision/geometry/mesh"]
    far = re.fullmatch(
        r"approximated: link 'tip' collides as the convex hull of corner.obj, "
        r"about (\d+) mm outside the mesh",
        note,
    )
    assert far is not None
    assert 300 < int(far[1]) <= 334  # the middle of the open face is a third from each plate
    whole = "kept: collides as its convex hull, which equals the mesh"
    assert parts["link/tip/collision[2]/geometry/mesh"] == whole
