import base64
import os
import re
from pathlib import Path

import pytest

pytest.importorskip("numpy")
pytest.importorskip("lxml")

import numpy as np

from tests.mesh import made
from tests.mesh.measures import bounds, volume
from urdfkit.mesh.convex_hull import hull
from urdfkit.mesh.geometry import Mesh, MeshMaterial, MeshPart
from urdfkit.mesh.io.load import UnloadableMesh, load, salvage
from urdfkit.mesh.writers import encode

PIXEL = base64.b64decode(
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
)

#: A unit square in the plane z = 0, of two triangles, with what a test adds.
SQUARE = """<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset>{asset}</asset>
  <library_effects>
    <effect id="look"><profile_COMMON>{parameters}
      <technique sid="common"><{shader}>{looks}</{shader}></technique>
    </profile_COMMON></effect>
  </library_effects>
  <library_images><image id="picture"><init_from>{image}</init_from></image></library_images>
  <library_materials>
    <material id="paint" name="red paint"><instance_effect url="{effect}"/></material>
  </library_materials>
  <library_geometries><geometry id="square"><mesh>
    <source id="places">
      <float_array id="numbers" count="12">{places}</float_array>
      <technique_common><accessor source="#numbers" count="4" stride="3">
        <param name="X" type="float"/><param name="Y" type="float"/><param name="Z" type="float"/>
      </accessor></technique_common>
    </source>
    <source id="ways">
      <float_array id="way_numbers" count="3">0 0 2</float_array>
      <technique_common><accessor source="#way_numbers" count="1" stride="3"/></technique_common>
    </source>
    <source id="flat">
      <float_array id="flat_numbers" count="8">0 0 1 0 1 1 0 1</float_array>
      <technique_common><accessor source="#flat_numbers" count="4" stride="2"/></technique_common>
    </source>
    <vertices id="corners"><input semantic="POSITION" source="#places"/></vertices>
    {surface}
  </mesh></geometry></library_geometries>
  <library_nodes>{library}</library_nodes>
  <library_visual_scenes><visual_scene id="scene">{nodes}</visual_scene></library_visual_scenes>
  <scene><instance_visual_scene url="#scene"/></scene>
</COLLADA>
"""
SHOWN = """<instance_geometry url="#square"><bind_material><technique_common>
  <instance_material symbol="symbol" target="#paint"/>
</technique_common></bind_material></instance_geometry>"""
TRIANGLES = """<triangles material="symbol" count="2">
  <input semantic="VERTEX" source="#corners" offset="0"/><p>0 1 2 0 2 3</p></triangles>"""
DEFAULTS = {
    "asset": "",
    "parameters": "",
    "shader": "phong",
    "looks": "<diffuse><color>1 0 0 1</color></diffuse>",
    "image": "picture.png",
    "effect": "#look",
    "places": "0 0 0 1 0 0 1 1 0 0 1 0",
    "surface": TRIANGLES,
    "library": "",
    "nodes": f"<node>{SHOWN}</node>",
}


def square(directory: Path, **changes: str) -> Mesh:
    path = directory / "square.dae"
    path.write_text(SQUARE.format(**DEFAULTS | changes), encoding="utf-8")
    return load(path)


def nodes(inside: str) -> str:
    return f"<node>{inside}{SHOWN}</node>"


def test_a_square(tmp_path: Path) -> None:
    mesh = square(tmp_path)
    (part,) = mesh.parts
    assert part.vertices.tolist() == [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]]
    assert part.faces.tolist() == [[0, 1, 2], [0, 2, 3]]
    assert part.material == MeshMaterial("red paint", (1, 0, 0, 1))
    assert (part.normals, part.uv, part.colors) == (None, None, None)
    assert (mesh.unit, mesh.up_axis, mesh.losses, mesh.extras) == (1, "", (), ())
    assert mesh.textures == ()


@pytest.mark.parametrize("defect", [b"name='<STL>'", b"name='&lt;' id=\"<a>\""])
@pytest.mark.parametrize("before", [b"", b'\n<?xml version="1.0" encoding="utf-8"?>'])
def test_what_other_readers_let_stand(tmp_path: Path, defect: bytes, before: bytes) -> None:
    square(tmp_path)
    (file,) = tmp_path.glob("*.dae")
    data = re.sub(rb"^<\?.*?\?>", b"", file.read_bytes())
    file.write_bytes(before + data.replace(b"<node", b"<node " + defect, 1) + b"\0\0")
    assert len(load(file).faces) == 2


def test_unit_and_axis_are_recorded_and_not_applied(tmp_path: Path) -> None:
    mesh = square(tmp_path, asset='<unit name="inch" meter="0.0254"/><up_axis>Y_UP</up_axis>')
    assert (mesh.unit, mesh.up_axis) == (0.0254, "Y_UP")
    assert bounds(mesh) == ((0, 0, 0), (1, 1, 0))


@pytest.mark.parametrize("meter", ["0", "-1", "nan", "one", "1 2", ""])
def test_a_unit_that_is_none(tmp_path: Path, meter: str) -> None:
    assert square(tmp_path, asset=f'<unit meter="{meter}"/>').unit == 1


INPUT = '<input semantic="VERTEX" source="#corners" offset="0"/>'


@pytest.mark.parametrize(
    ("surface", "faces"),
    [
        (f"<polylist count='1'>{INPUT}<vcount>4</vcount><p>0 1 2 3</p></polylist>", 2),
        (f"<polylist count='2'>{INPUT}<vcount>2 3</vcount><p>0 1 1 2 3</p></polylist>", 1),
        (f"<polygons count='2'>{INPUT}<p>0 1 2</p><p>0 2 3</p></polygons>", 2),
        (f"<trifans count='1'>{INPUT}<p>0 1 2 3</p></trifans>", 2),
        (f"<tristrips count='1'>{INPUT}<p>0 1 3 2</p></tristrips>", 2),
        (f"<triangles count='1'>{INPUT}<p>0 1 2</p></triangles>" * 2, 2),
    ],
)
def test_every_kind_of_surface_looks_upwards(tmp_path: Path, surface: str, faces: int) -> None:
    mesh = square(tmp_path, surface=surface)
    assert len(mesh.faces) == faces
    a, b, c = (mesh.vertices[mesh.faces[:, i]] for i in range(3))
    ups = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    assert ups.tolist() == [1] * faces  # twice the area of half a square
    assert mesh.losses == ()


def test_a_list_for_each_polygon(tmp_path: Path) -> None:
    """Of which one ends within a corner, and one is empty."""
    both = INPUT + '<input semantic="VERTEX" source="#corners" offset="1"/>'
    lists = ("0 9 1 9 2 9 3", "", "0 9 2 9 3 9 1 9")
    surface = f"<polygons>{both}{''.join(f'<p>{each}</p>' for each in lists)}</polygons>"
    mesh = square(tmp_path, surface=surface)
    corners = mesh.vertices[mesh.faces][:, :, :2].tolist()
    assert corners[0] == [[0, 0], [1, 0], [1, 1]]
    assert len(corners) == 3
    assert mesh.losses[0] == "1 truncated list of corners"


@pytest.mark.parametrize(
    ("moves", "corner"),
    [
        ("<translate>1 2 3</translate>", (2, 3, 3)),
        ("<scale>2 3 4</scale>", (2, 3, 0)),
        ("<rotate>0 0 1 90</rotate>", (-1, 1, 0)),
        ("<rotate>0 0 2 90</rotate><translate>1 0 0</translate>", (-1, 2, 0)),
        ("<translate>1 0 0</translate><rotate>0 0 1 90</rotate>", (0, 1, 0)),
        ("<matrix>0 -1 0 5  1 0 0 0  0 0 1 0  0 0 0 1</matrix>", (4, 1, 0)),
    ],
)
def test_moves_of_nodes(tmp_path: Path, moves: str, corner: tuple[float, ...]) -> None:
    mesh = square(tmp_path, nodes=nodes(moves))
    assert mesh.vertices[2].tolist() == pytest.approx(corner, abs=1e-12)


def test_nodes_in_nodes_and_instances_of_nodes(tmp_path: Path) -> None:
    mesh = square(
        tmp_path,
        library=f'<node id="copied"><translate>1 0 0</translate>{SHOWN}</node>',
        nodes="<node><scale>2 2 2</scale><node><translate>0 3 0</translate>"
        '<instance_node url="#copied"/></node></node>'
        '<node><instance_node url="#copied"/></node>',
    )
    assert [bounds(Mesh((part,)))[0] for part in mesh.parts] == [(2, 6, 0), (1, 0, 0)]


def test_a_mirrored_node_keeps_its_outside_outside(tmp_path: Path) -> None:
    folded = "0 0 0 1 0 0 0 1 0 0 0 1"
    tetrahedron = f"<triangles count='4'>{INPUT}<p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>"
    for moves in ("", "<scale>-1 1 1</scale>"):
        mesh = square(tmp_path, places=folded, surface=tetrahedron, nodes=nodes(moves))
        assert volume(mesh) == pytest.approx(1 / 6)


ALL_INPUTS = """<triangles material="symbol" count="2">
  <input semantic="VERTEX" source="#corners" offset="0"/>
  <input semantic="NORMAL" source="#ways" offset="1"/>
  <input semantic="TEXCOORD" source="#flat" offset="2" set="1"/>
  <p>0 0 0 1 0 1 2 0 2 0 0 3 2 0 2 3 0 0</p></triangles>"""


def test_corners_with_normals_and_texture_coordinates(tmp_path: Path) -> None:
    (part,) = square(tmp_path, surface=ALL_INPUTS, nodes=nodes("<rotate>1 0 0 90</rotate>")).parts
    assert len(part.vertices) == 5  # the first corner has two places in the image
    assert part.normals is not None
    assert part.uv is not None
    assert part.normals.tolist() == [pytest.approx([0, -1, 0], abs=1e-12)] * 5
    at = {
        (*map(float, v.round(9)), *map(float, uv))
        for v, uv in zip(part.vertices, part.uv, strict=True)
    }
    assert at == {
        (0, 0, 0, 0, 0), (1, 0, 0, 1, 0), (1, 0, 1, 1, 1), (0, 0, 0, 0, 1), (0, 0, 1, 0, 0)
    }  # fmt: skip
    assert part.vertices[part.faces[1]].round(9).tolist() == [[0, 0, 0], [1, 0, 1], [0, 0, 1]]


PARAMETERS = """<newparam sid="surface"><surface type="2D"><init_from>picture</init_from></surface>
  </newparam><newparam sid="sampler"><sampler2D><source>surface</source></sampler2D></newparam>"""
TEXTURED = '<diffuse><texture texture="{}" texcoord="UV"/></diffuse>'


@pytest.mark.parametrize(("sampler", "parameters"), [("sampler", PARAMETERS), ("picture", "")])
@pytest.mark.parametrize("image", ["picture.png", "./picture.png", "file:///elsewhere/picture.png"])
def test_a_texture(tmp_path: Path, sampler: str, parameters: str, image: str) -> None:
    (tmp_path / "picture.png").write_bytes(PIXEL)
    mesh = square(tmp_path, looks=TEXTURED.format(sampler), parameters=parameters, image=image)
    expected = MeshMaterial("red paint", (1, 1, 1, 1), str(tmp_path / "picture.png"))
    assert mesh.parts[0].material == expected
    assert (mesh.losses, mesh.textures, mesh.missing) == ((), (image,), ())


@pytest.mark.parametrize(
    ("reference", "expected"), [("cover", "cover.jpg"), ("../cover.png", "../cover.png")]
)
def test_an_image_that_the_library_lacks(tmp_path: Path, reference: str, expected: str) -> None:
    """As in ANYmal D's meshes, whose textures assimp finds."""
    parameters = PARAMETERS.replace("picture", reference)
    mesh = square(tmp_path, looks=TEXTURED.format("sampler"), parameters=parameters)
    assert mesh.missing == (expected,)
    (tmp_path / os.path.basename(expected)).write_bytes(PIXEL)
    mesh = square(tmp_path, looks=TEXTURED.format("sampler"), parameters=parameters)
    assert mesh.missing == ()
    assert mesh.parts[0].material is not None
    assert mesh.parts[0].material.texture == str(tmp_path / os.path.basename(expected))


def test_decimal_commas_are_named(tmp_path: Path) -> None:
    with pytest.raises(UnloadableMesh, match=r"with a decimal comma, such as .0,5."):
        square(tmp_path, places="0,5 0 0 1,0 0 0 1 1,0 0 0,0 1,0 0,0")


def test_a_texture_that_is_missing(tmp_path: Path) -> None:
    mesh = square(tmp_path, looks=TEXTURED.format("sampler"), parameters=PARAMETERS)
    assert mesh.parts[0].material == MeshMaterial("red paint")
    assert mesh.missing == ("picture.png",)
    assert mesh.losses == ()


@pytest.mark.parametrize(
    ("looks", "alpha"),
    [
        ("", 1),
        ("<transparency><float>0</float></transparency>", 1),
        ('<transparent opaque="A_ONE"><color>0 0 0 0.5</color></transparent>', 0.5),
        (("<transparent><color>0 0 0 0.5</color></transparent>"
         "<transparency><float>0.5</float></transparency>"), 0.25),
        (("<transparent><color>0 0 0 1</color></transparent>"
         "<transparency><float>0</float></transparency>"), 1),
        ('<transparent opaque="RGB_ZERO"><color>0 0 0 1</color></transparent>', 1),
        (('<transparent opaque="RGB_ZERO"><color>1 1 1 1</color></transparent>'
         "<transparency><float>0.25</float></transparency>"), 0.75),
        ('<transparent opaque="A_ZERO"><color>0 0 0 0.25</color></transparent>', 0.75),
        ('<transparent opaque="RGB_ONE"><color>0.5 0.5 0.5 0</color></transparent>', 0.5),
    ],
)  # fmt: skip
def test_transparency(tmp_path: Path, looks: str, alpha: float) -> None:
    mesh = square(tmp_path, looks=f"<diffuse><color>1 0 0 1</color></diffuse>{looks}")
    assert mesh.parts[0].material is not None
    assert mesh.parts[0].material.rgba == pytest.approx((1, 0, 0, alpha), abs=1e-6)


def test_a_constant_shader_shines(tmp_path: Path) -> None:
    looks = "<emission><color>0 1 0 1</color></emission>"
    mesh = square(tmp_path, shader="constant", looks=looks)
    assert mesh.parts[0].material == MeshMaterial("red paint", (0, 1, 0, 1))


@pytest.mark.parametrize(
    ("changes", "losses"),
    [
        ({"looks": "<diffuse><color>0.01.0 0 1</color></diffuse>"},
         "1 colour that cannot be read ('0.01.0 0 1')"),
        ({"effect": "#none"}, "1 material without a readable effect"),
        ({"nodes": f"<node>{SHOWN.replace('#paint', '#none')}</node>"},
         "1 material missing from the file"),
        ({"nodes": nodes("<translate>1 2</translate>")}, "1 <translate> that cannot be read"),
        ({"nodes": f"<node>{SHOWN}<instance_node url='#none'/></node>"},
         "1 node missing from the file"),
        ({"places": "0 0 0 1 0 0 1 1 0 0 nan 0"},
         "1 triangle with a coordinate that is not finite"),
        ({"surface": TRIANGLES.replace("0 2 3", "0 2 4")},
         "1 triangle with a vertex that is not in the file"),
    ],
)  # fmt: skip
def test_one_defect_loses_nothing_else(
    tmp_path: Path, changes: dict[str, str], losses: str
) -> None:
    mesh = square(tmp_path, **changes)
    assert len(mesh.faces) == (1 if "triangle" in losses else 2)
    assert mesh.losses == (losses,)


def test_what_is_no_triangle(tmp_path: Path) -> None:
    lines = f"<lines count='1'>{INPUT}<p>0 1</p></lines>"
    inside = "<instance_camera url='#a'/><instance_light url='#b'/><instance_light url='#c'/>"
    mesh = square(tmp_path, surface=lines + TRIANGLES, nodes=nodes(inside))
    assert mesh.extras == ("1 line set", "1 camera", "2 lights")
    assert mesh.losses == ()


def test_a_node_that_contains_itself(tmp_path: Path) -> None:
    itself = f'<node id="a">{SHOWN}<instance_node url="#a"/></node>'
    mesh = square(tmp_path, nodes=itself)
    assert len(mesh.faces) == 2
    assert mesh.losses == ("1 reference of a node to itself",)


def test_nodes_that_multiply(tmp_path: Path) -> None:
    doubling = "".join(
        f'<node id="n{i}"><instance_node url="#n{i + 1}"/><instance_node url="#n{i + 1}"/></node>'
        for i in range(60)
    )
    library = f'{doubling}<node id="n60">{SHOWN}</node>'
    with pytest.raises(UnloadableMesh, match="has more than"):
        square(tmp_path, library=library, nodes='<node><instance_node url="#n0"/></node>')


def test_nodes_within_nodes_ten_thousand_deep(tmp_path: Path) -> None:
    deep = "<node>" * 10_000 + SHOWN + "</node>" * 10_000
    with pytest.raises(UnloadableMesh):
        square(tmp_path, nodes=deep)


BOMB = f'<!ENTITY a "{"x" * 1000}">' + "".join(
    f'<!ENTITY {one} "{f"&{other};" * 100}">' for one, other in ("ba", "cb", "dc", "ed")
)


#: Expat expands these by recursion: 60,000 levels overflow its stack.
DEEP = '<!ENTITY e0 "">' + "".join(f'<!ENTITY e{n} "&e{n - 1};">' for n in range(1, 60_000))


@pytest.mark.parametrize("encoding", ["utf-8", "utf-16"])
@pytest.mark.parametrize("entities", ['<!ENTITY e "harmless">', BOMB])
def test_entities_are_refused(tmp_path: Path, entities: str, encoding: str) -> None:
    path = tmp_path / "bomb.dae"
    head = f'<?xml version="1.0"?><!DOCTYPE COLLADA [{entities}]>'
    body = made.collada().decode().partition("?>")[2]
    body = body.replace("<asset>", "<asset><title>&e;</title>")
    path.write_bytes((head + body).encode(encoding))
    for read in (load, salvage):
        with pytest.raises(UnloadableMesh, match="declares XML entities"):
            read(path)


def test_deep_entities_are_refused(tmp_path: Path) -> None:
    path = tmp_path / "deep.dae"
    body = made.collada().decode().partition("?>")[2].replace("<asset>", '<asset a="&e59999;">')
    path.write_text(f"<!DOCTYPE COLLADA [{DEEP}]>{body}")
    for read in (load, salvage):
        with pytest.raises(UnloadableMesh, match="declares XML entities"):
            read(path)


def test_other_encodings(tmp_path: Path) -> None:
    text = made.collada().decode().replace("<asset>", "<asset><title>ж</title>")
    for encoding in ("utf-8", "utf-16", "koi8-r"):
        path = tmp_path / f"{encoding}.dae"
        path.write_bytes(text.replace("utf-8", encoding).encode(encoding))
        assert len(load(path).faces) == 1


def test_what_is_left_of_a_truncated_file(tmp_path: Path) -> None:
    text = SQUARE.format(**DEFAULTS)
    path = tmp_path / "cut.dae"
    path.write_text(text[: text.index("</visual_scene>")], encoding="utf-8")
    with pytest.raises(UnloadableMesh, match="ends inside <visual_scene>"):
        load(path)
    mesh = salvage(path)
    assert len(mesh.faces) == 2
    assert mesh.parts[0].material == MeshMaterial("red paint", (1, 0, 0, 1))


def test_what_is_left_of_a_file_without_its_end_is_shown_where_it_is(tmp_path: Path) -> None:
    corners = np.array([[x, y, z] for x in (0, 1) for y in (0, 2) for z in (0, 3)], dtype=float)
    whole = hull(Mesh((MeshPart(corners, np.arange(8).reshape(1, -1)),)))
    data = encode(whole, "a.dae")["a.dae"]
    start, end = data.index(b"<p>"), data.index(b"</p>")
    path = tmp_path / "a.dae"
    for cut, triangles in ((start + (end - start) // 2, 5), (end + 20, 12)):
        path.write_bytes(data[:cut])
        left = salvage(path)
        assert abs(len(left.faces) - triangles) <= 1
        assert np.ptp(left.vertices, axis=0) == pytest.approx([1, 2, 3])
        assert "1 geometry without a place in the scene" in left.losses
    path.write_bytes(data[: data.index(b"<vertices")])
    with pytest.raises(UnloadableMesh):
        salvage(path)


def test_ids_that_two_geometries_have(tmp_path: Path) -> None:
    """Each geometry refers to its own sources, as in assimp."""
    expected = square(tmp_path).parts[0].vertices.tolist()
    path = tmp_path / "square.dae"
    text = path.read_text(encoding="utf-8")
    (geometry,) = re.findall(r"<geometry.*</geometry>", text, re.DOTALL)
    point = geometry.replace('"square"', '"point"').replace("0 0 0 1 0 0 1 1 0 0 1 0", "0 0 0")
    path.write_text(text.replace(geometry, point + geometry), encoding="utf-8")
    mesh = load(path)
    assert mesh.parts[0].vertices.tolist() == expected
    assert mesh.losses == ("2 repeated ids, of which Gazebo reads the first",)
