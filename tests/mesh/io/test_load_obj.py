from pathlib import Path

import pytest

pytest.importorskip("numpy")

from tests.mesh.measures import bounds
from urdfkit.mesh.geometry import Mesh, MeshMaterial
from urdfkit.mesh.io.load import UnloadableMesh, load

SQUARE = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"


def read(directory: Path, text: str, **others: str) -> Mesh:
    for name, content in others.items():
        (directory / name.replace("_", ".")).write_text(content, encoding="utf-8")
    path = directory / "part.obj"
    path.write_text(text, encoding="utf-8")
    return load(path)


@pytest.mark.parametrize(
    "faces",
    [
        "f 1 2 3 4\n",
        "f 1 2 3\nf 1 3 4\n",
        "f -4 -3 -2 -1\n",
        "f 1 2 \\\n3 4\n",
        "f 1 2 3 4 # a comment\n",
        "g a\nf 1 2 3\ng b\ns off\nf 1 3 4\n",
        "f 1/ 2/ 3/ 4/\n",
        "f 1// 2// 3// 4//",
    ],
)
def test_a_square(tmp_path: Path, faces: str) -> None:
    mesh = read(tmp_path, SQUARE + faces)
    (part,) = mesh.parts
    assert part.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert part.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert part[2:] == (None, None, None, None)
    assert (mesh.losses, mesh.extras, mesh.unit, mesh.up_axis) == ((), (), 1, "")


def test_indices_that_count_backwards_count_from_their_line(tmp_path: Path) -> None:
    mesh = read(tmp_path, "v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -4 -3 -1\n")
    assert mesh.vertices[mesh.faces[0]].tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    assert mesh.vertices[mesh.faces[1]].tolist() == [[0, 0, 0], [1, 0, 0], [9, 9, 9]]


def test_normals_and_texture_coordinates(tmp_path: Path) -> None:
    rest = "vt 0 0\nvt 1 1 0\nvn 0 0 2\nf 1/1/1 2/2/1 3/2/1\nf 1/2/1 3/2/1 4/2/1\n"
    (part,) = read(tmp_path, SQUARE + rest).parts
    assert len(part.vertices) == 5
    assert part.normals is not None
    assert part.uv is not None
    assert part.normals.tolist() == [[0, 0, 1]] * 5
    assert part.uv[part.faces[0]].tolist() == [[0, 0], [1, 1], [1, 1]]
    assert part.uv[part.faces[1]].tolist() == [[1, 1]] * 3


def test_normals_without_texture_coordinates(tmp_path: Path) -> None:
    (part,) = read(tmp_path, f"{SQUARE}vn 0 0 1\nf 1//1 2//1 3//1\n").parts
    assert part.normals is not None
    assert part.normals.tolist() == [[0, 0, 1]] * 3
    assert part.uv is None


def test_colours_of_vertices(tmp_path: Path) -> None:
    (part,) = read(tmp_path, "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 2\nf 1 2 3\n").parts
    assert part.colors is not None
    assert part.colors.tolist() == [[1, 0, 0, 1], [0, 1, 0, 1], [0, 0, 1, 1]]


MTL = """
newmtl red
Kd 1 0 0
d 0.5
newmtl glass
Tr 0.75
newmtl picture
map_Kd -s 1 1 1 -clamp on a picture.png
"""


def test_materials(tmp_path: Path) -> None:
    (tmp_path / "a picture.png").write_bytes(b"")
    text = (
        f"mtllib my.mtl\n{SQUARE}f 1 2 3\nusemtl red\nf 1 2 3\nusemtl glass\nf 1 2 3\n"
        "usemtl picture\nf 1 2 3\nusemtl red\nf 1 2 4\nusemtl unknown\nf 1 2 3\n"
    )
    mesh = read(tmp_path, text, my_mtl=MTL)
    default = MeshMaterial().rgba
    assert [part.material for part in mesh.parts] == [
        None,
        MeshMaterial("red", (1, 0, 0, 0.5)),
        MeshMaterial("glass", (*default[:3], 0.25)),
        MeshMaterial("picture", default, str(tmp_path / "a picture.png")),
        MeshMaterial("red", (1, 0, 0, 0.5)),
        MeshMaterial("unknown"),
    ]
    assert mesh.textures == ("a picture.png",)
    assert mesh.losses == ()


def test_meshlab_writes_a_transparency_of_1_for_opaque(tmp_path: Path) -> None:
    text = f"mtllib my.mtl\n{SQUARE}usemtl a\nf 1 2 3\n"
    (part,) = read(tmp_path, text, my_mtl="newmtl a\nKd 1 0 0\nTr 1.000000\n").parts
    assert part.material == MeshMaterial("a", (1, 0, 0, 1))


def test_materials_that_are_missing(tmp_path: Path) -> None:
    mesh = read(tmp_path, f"mtllib my.mtl\nmtllib none.mtl\n{SQUARE}f 1 2 3", my_mtl=MTL)
    assert mesh.missing == ("a picture.png", "none.mtl")
    assert mesh.losses == ()


@pytest.mark.parametrize(
    ("text", "losses"),
    [
        ("f 1 2 3\nf 1 2 0\n", ("1 triangle with a vertex that is not in the file",)),
        ("f 1 2 3\nf 1 2 x\n", ("1 triangle with a vertex that is not in the file",)),
        ("vn 0 0 1\nf 1//1 2//1 3//7\n", ("1 surface whose normals are not in the file",)),
        ("v nan 0 0\nf 1 2 3\nf 1 2 5\n",
         ("1 triangle with a coordinate that is not finite",)),
        ("v 1 2\nf 1 2 3\nf 1 2 5\n",
         ("1 triangle with a coordinate that is not finite",)),
        ("f 1 2 3\nf 1 2\nf\n", ()),
    ],
)  # fmt: skip
def test_one_defect_loses_nothing_else(tmp_path: Path, text: str, losses: tuple[str, ...]) -> None:
    mesh = read(tmp_path, SQUARE + text)
    assert len(mesh.faces) == 1
    assert bounds(mesh) == ((0, 0, 0), (1, 1, 0))
    assert mesh.losses == losses


def test_what_is_no_triangle(tmp_path: Path) -> None:
    assert read(tmp_path, f"{SQUARE}l 1 2\nl 2 3\nf 1 2 3\n").extras == ("2 lines",)
    with pytest.raises(UnloadableMesh, match="contains no triangles"):
        read(tmp_path, f"{SQUARE}f 0 0 0\nf 1 2\n")


def test_thousands_of_materials_are_bounded(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setattr("urdfkit.mesh.io.assemble.MAX_PARTS", 9)
    faces = "".join(f"usemtl m{number}\nf 1 2 3\n" for number in range(10))
    path = tmp_path / "a.obj"
    path.write_text(f"v 0 0 0\nv 1 0 0\nv 0 1 0\n{faces}")
    with pytest.raises(UnloadableMesh, match="has more than 9 surfaces"):
        load(str(path))
