"""From a description to triangles: looks, textures, placeholders, places."""

from pathlib import Path

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from tests.conftest import MODELS
from tests.render.scenes import alone, colour_at, link, robot
from urdfkit.lint.loading import read
from urdfkit.render import build, place_camera
from urdfkit.render.scene import PLACEHOLDER_SIZE
from urdfkit.render.textures import texture
from urdfkit.ros.surface_materials import PLACEHOLDER, PLAIN
from urdfkit.text.source import Source

SIZE = (200, 200)

QUAD = """mtllib quad.mtl
v 0 -1 -1
v 0 1 -1
v 0 1 1
v 0 -1 1
vt 0 0
vt 1 0
vt 1 1
vt 0 1
usemtl painted
f 1/1 2/2 3/3 4/4
"""
MATERIAL = "newmtl painted\nKd 1 1 1\nmap_Kd quarters.png\n"


@pytest.fixture
def quad(tmp_path: Path) -> Path:
    """A square that faces +x, with red, green, blue and white in its quarters."""
    pixels = np.zeros((2, 2, 3), dtype=np.uint8)
    pixels[0] = (255, 0, 0), (0, 255, 0)  # the upper row
    pixels[1] = (0, 0, 255), (255, 255, 255)
    image = Image.fromarray(pixels).resize((64, 64), Image.Resampling.NEAREST)
    image.save(tmp_path / "quarters.png")
    (tmp_path / "quad.obj").write_text(QUAD, encoding="utf-8")
    (tmp_path / "quad.mtl").write_text(MATERIAL, encoding="utf-8")
    return tmp_path


def seen(directory: Path, visual: str, view: str = "front") -> list[str]:
    """The colours of the quarters of a robot: upper left and right, lower left and right."""
    file = directory / "robot.urdf"
    text = f'<robot name="r"><link name="a"><visual>{visual}</visual></link></robot>'
    file.write_text(text, encoding="utf-8")
    scene = build(read(file))
    pixels = alone(scene, place_camera(scene.points(), view, size=SIZE))
    return [colour_at(pixels, x, y) for y in (60, 140) for x in (60, 140)]


MESH = '<geometry><mesh filename="quad.obj"{}/></geometry>'


def test_a_texture_is_the_right_way_up_and_not_mirrored(quad: Path) -> None:
    upper_left, upper_right, lower_left, _ = seen(quad, MESH.format(""))
    assert (upper_left, upper_right, lower_left) == ("red", "green", "blue")


def test_a_changed_image_is_read_again(tmp_path: Path) -> None:
    file = tmp_path / "paint.png"
    shown = []
    for colour in ("red", "blue"):
        Image.new("RGB", (1, 1), colour).save(file)
        image = texture(str(file))
        shown.append(image and image.png())
    assert shown[0] != shown[1]


def test_a_mirrored_mesh_has_a_mirrored_texture(quad: Path) -> None:
    upper_left, upper_right, _, lower_right = seen(quad, MESH.format(' scale="1 -1 1"'))
    assert (upper_left, upper_right, lower_right) == ("green", "red", "blue")


def test_a_colour_of_the_urdf_replaces_what_the_mesh_brings_along(quad: Path) -> None:
    paint = '<material name="m"><color rgba="0 0 1 1"/></material>'
    assert seen(quad, MESH.format("") + paint) == ["blue"] * 4


def test_a_texture_of_the_urdf_is_on_every_side_of_a_box(quad: Path) -> None:
    paint = '<material name="m"><texture filename="quarters.png"/></material>'
    for view in ("front", "left", "top", "back", "right"):
        quarters = seen(quad, f'<geometry><box size="1 1 1"/></geometry>{paint}', view)
        assert {"red", "green", "blue"} <= set(quarters)


def test_a_texture_on_a_mesh_without_coordinates_paints_all_of_it_alike(quad: Path) -> None:
    plain = "\n".join(line for line in QUAD.splitlines() if line[:2] not in ("vt", "us", "mt"))
    Image.new("RGB", (4, 4), (0, 0, 255)).save(quad / "quarters.png")
    (quad / "quad.obj").write_text(plain.replace("f 1/1 2/2 3/3 4/4", "f 1 2 3 4"))
    paint = '<material name="m"><texture filename="quarters.png"/></material>'
    assert seen(quad, MESH.format("") + paint) == ["blue"] * 4


@pytest.mark.parametrize("content", [b"", b"no image", b"\x89PNG\r\n\x1a\n" + bytes(40)])
def test_a_broken_texture_leaves_the_surface(quad: Path, content: bytes) -> None:
    (quad / "quarters.png").write_bytes(content)
    assert "none" not in seen(quad, MESH.format(""))


def test_gazebo_colours_count_where_nothing_else_says_anything() -> None:
    body = '<link name="{}"><visual><geometry><box size="1 1 1"/></geometry>{}</visual></link>'
    gazebo = '<gazebo reference="{}"><material>Gazebo/Orange</material></gazebo>'
    context = robot(
        body.format("plain", "") + gazebo.format("plain"),
        body.format("blue", '<material name="b"><color rgba="0 0 1 1"/></material>')
        + gazebo.format("blue"),
        body.format("bare", ""),
    )
    looks = {item.link: item.material for item in build(context).items}
    assert looks["plain"].rgba[0] > looks["plain"].rgba[1] > looks["plain"].rgba[2]
    assert looks["blue"].rgba[:3] == (0, 0, 1)
    assert looks["bare"] == PLAIN


@pytest.mark.parametrize("content", [None, b"", b"solid x\nfacet"])
def test_a_mesh_that_is_not_to_be_had_is_a_marked_box(
    tmp_path: Path, content: bytes | None
) -> None:
    if content is not None:
        (tmp_path / "gone.stl").write_bytes(content)
    file = tmp_path / "robot.urdf"
    mesh = '<geometry><mesh filename="gone.stl"/></geometry>'
    file.write_text(
        f'<robot name="r"><link name="a"><visual><origin xyz="0 0 2"/>{mesh}</visual>'
        '<collision><geometry><box size="1 2 3"/></geometry></collision></link></robot>',
        encoding="utf-8",
    )
    scene = build(read(file))
    (item,) = scene.items
    assert item.material == PLACEHOLDER
    assert np.ptp(item.vertices, axis=0) == pytest.approx((1, 2, 3))
    assert item.vertices.mean(axis=0) == pytest.approx((0, 0, 2), abs=1e-6)
    (missing,) = scene.missing
    assert (missing.link, missing.role, missing.filename) == ("a", "visual", "gone.stl")
    assert missing.reason


def test_a_box_for_a_mesh_is_as_large_as_the_mesh_beside_it(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    trimesh.creation.box((0.1, 0.2, 0.3)).export(tmp_path / "there.stl")
    file = tmp_path / "robot.urdf"
    file.write_text(
        '<robot name="r"><link name="a"><visual><geometry><mesh filename="gone.stl"/></geometry>'
        '</visual><collision><origin xyz="0 0 5"/><geometry>'
        '<mesh filename="there.stl" scale="2 2 2"/></geometry></collision></link></robot>',
        encoding="utf-8",
    )
    (item,) = build(read(file)).items
    assert item.material == PLACEHOLDER
    assert np.ptp(item.vertices, axis=0) == pytest.approx((0.2, 0.4, 0.6))
    assert item.vertices.mean(axis=0) == pytest.approx((0, 0, 5), abs=1e-6)


def test_a_speck_for_a_collision_does_not_hide_the_box_for_a_mesh(tmp_path: Path) -> None:
    """CAD exporters write collisions of a micrometre where they mean none."""
    (tmp_path / "robot.urdf").write_text(
        '<robot name="r">'
        '<link name="base"><visual><geometry><box size="1 1 1"/></geometry></visual>'
        '</link><link name="a"><visual><geometry><mesh filename="lost.stl"/></geometry></visual>'
        '<collision><geometry><box size="1e-6 1e-6 1e-6"/></geometry></collision></link>'
        '<joint name="j" type="fixed"><parent link="base"/><child link="a"/></joint></robot>'
    )
    scene = build(read(tmp_path / "robot.urdf"))
    (box,) = (item for item in scene.items if item.link == "a")
    assert np.ptp(box.vertices, axis=0) == pytest.approx([PLACEHOLDER_SIZE * 3**0.5] * 3)


def test_a_box_for_a_mesh_of_which_nothing_is_known_reaches_to_the_next_joints() -> None:
    mesh = '<link name="{}"><visual><geometry><mesh filename="no.stl"/></geometry></visual></link>'
    joint = (
        '<joint name="j" type="fixed"><origin xyz="0 0 2"/><parent link="a"/>'
        '<child link="b"/></joint>'
    )
    upper, lower = build(robot(mesh.format("a"), mesh.format("b"), joints=joint)).items[::-1]
    assert lower.vertices[:, 2].min() == pytest.approx(0)
    assert lower.vertices[:, 2].max() == pytest.approx(2)
    assert np.ptp(upper.vertices, axis=0).max() < 0.2


def test_every_visual_of_the_models_is_drawn_or_said_to_be_missing() -> None:
    for file in sorted((MODELS / "good").rglob("*.urdf")):
        context = read(file)
        scene = build(context, roles=("visual", "collision"))
        shapes = sum(len(link.visuals) + len(link.collisions) for link in context.model.links)
        drawn = {(item.link, item.role) for item in scene.items}
        assert len(scene.items) >= shapes
        for one in context.model.links:
            assert not one.visuals or (one.name, "visual") in drawn


HOSTILE = [
    '<box size="nan 1 1"/>',
    '<box size="0 0 0"/>',
    '<box size="1e30 1 1"/>',
    '<box size="-1 1 1"/>',
    '<sphere radius="1e-30"/>',
    '<cylinder radius="inf" length="1"/>',
    '<mesh filename=""/>',
    '<mesh filename="/dev/zero"/>',
    '<plane normal="0 0 1"/>',
]


@pytest.mark.parametrize("shape", HOSTILE)
def test_no_shape_stops_an_image(shape: str) -> None:
    scene = build(robot(link("a", shape), link("b", '<box size="1 1 1"/>', "1e3 0 0")))
    assert alone(scene, place_camera(scene.points(), size=(64, 64))).shape == (64, 64, 4)


@pytest.mark.parametrize("xyz", ["1e30 0 0", "1e300 1e300 0", "nan 0 0"])
def test_no_place_stops_an_image(xyz: str) -> None:
    scene = build(robot(link("a", '<box size="1 1 1"/>', xyz), link("b", '<box size="1 1 1"/>')))
    assert alone(scene, place_camera(scene.points(), size=(64, 64))).any()


@pytest.mark.parametrize("size", [1e-45, 1e-12, 1e38, 1e300])
def test_no_size_stops_an_image(size: float) -> None:
    """Nor warns, nor makes placeholders of that size."""
    mesh = '<link name="{}"><visual><geometry><mesh filename="no.stl"/></geometry></visual></link>'
    joint = (
        f'<joint name="j" type="fixed"><origin xyz="0 {size} {size}"/><parent link="a"/>'
        '<child link="b"/></joint>'
    )
    ball = link("c", f'<sphere radius="{size}"/>')
    scene = build(robot(mesh.format("a"), mesh.format("b"), ball, joints=joint))
    assert max(np.abs(item.vertices).max() for item in scene.items) < 10
    pixels = alone(scene, place_camera(scene.points(), size=(64, 64)), quality="high")
    assert pixels.shape == (64, 64, 4)


def test_links_in_a_loop_and_islands_do_not_stop_an_image() -> None:
    box = '<box size="1 1 1"/>'
    loop = "".join(
        f'<joint name="{a}{b}" type="fixed"><parent link="{a}"/><child link="{b}"/></joint>'
        for a, b in ("bc", "cb")
    )
    scene = build(robot(link("a", box), link("b", box), link("c", box), joints=loop))
    assert {item.link for item in scene.items} == {"a"}


def test_the_material_of_a_glb_is_seen(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((1, 1, 1))
    box.visual = trimesh.visual.TextureVisuals(
        material=trimesh.visual.material.PBRMaterial(baseColorFactor=(0, 255, 0, 255))
    )
    box.export(tmp_path / "box.glb")
    quarters = seen(tmp_path, '<geometry><mesh filename="box.glb"/></geometry>')
    assert quarters == ["green"] * 4


def test_the_colours_of_vertices_are_seen(tmp_path: Path) -> None:
    trimesh = pytest.importorskip("trimesh")
    box = trimesh.creation.box((1, 1, 1))
    colours = np.tile(np.array((0, 0, 255, 255), dtype=np.uint8), (len(box.vertices), 1))
    colours[box.vertices[:, 1] > 0] = (255, 0, 0, 255)
    box.visual = trimesh.visual.ColorVisuals(vertex_colors=colours)
    box.export(tmp_path / "box.ply")
    quarters = seen(tmp_path, '<geometry><mesh filename="box.ply"/></geometry>')
    assert quarters == ["blue", "red", "blue", "red"]  # +y is at the right, seen from the front


DAE = """<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="0.5"/><up_axis>Z_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert><diffuse>
<color>0 1 0 1</color></diffuse></lambert></technique></profile_COMMON></effect></library_effects>
<library_materials><material id="m"><instance_effect url="#e"/></material></library_materials>
<library_geometries><geometry id="g"><mesh><source id="p"><float_array id="a" count="12">
0 -1 -1 0 1 -1 0 1 1 0 -1 1</float_array><technique_common><accessor source="#a" count="4"
stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z"
type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION"
source="#p"/></vertices><triangles material="s" count="2"><input semantic="VERTEX" source="#v"
offset="0"/><p>0 1 2 0 2 3</p></triangles></mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="c"><node><instance_geometry url="#g"><bind_material>
<technique_common><instance_material symbol="s" target="#m"/></technique_common></bind_material>
</instance_geometry></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#c"/></scene></COLLADA>"""


def test_the_effect_and_the_unit_of_a_collada_file_count(tmp_path: Path) -> None:
    pytest.importorskip("lxml")
    (tmp_path / "quad.dae").write_text(DAE, encoding="utf-8")
    mesh = '<geometry><mesh filename="quad.dae"/></geometry>'
    assert seen(tmp_path, mesh) == ["green"] * 4
    points = build(read(tmp_path / "robot.urdf")).points()
    assert np.ptp(points, axis=0) == pytest.approx((0, 1, 1))


def test_roots_that_share_a_place_are_reported() -> None:
    """Nothing says how they stand to one another; what is not drawn does not matter."""
    ball = '<visual><geometry><sphere radius="1"/></geometry></visual>'
    two = f'<link name="a">{ball}</link><link name="b">{ball}</link>'

    def notes(text: str) -> tuple[str, ...]:
        return build(read(Source("r.urdf", f'<robot name="r">{text}</robot>'.encode()))).notes

    (note,) = notes(two)
    assert note.startswith("2 roots are drawn at the same position")
    assert notes(two.replace(ball, "", 1)) == ()
