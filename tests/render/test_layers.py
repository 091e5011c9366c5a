"""Layers over a robot: where overlays stand, and that they tell the truth."""

from math import pi
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np

from tests.conftest import ARM
from tests.render.scenes import alone, link, robot
from urdfkit.lint.loading import read
from urdfkit.render import LAYERS, build, labels, place_camera, render_image, with_layers
from urdfkit.render.fonts import writing
from urdfkit.render.layers import ADJACENT, INERTIA, MASS, OVERLAP, ROBOT, NoSuchLayer
from urdfkit.render.scene import SceneItem, placed
from urdfkit.ros.surface_materials import COLLISION, PLACEHOLDER, SurfaceMaterial

SOLID = (
    '<inertial><origin xyz="0.1 0 0" rpy="0 0 0.5"/><mass value="12"/>'
    '<inertia ixx="{}" ixy="0" ixz="0" iyy="{}" iyz="0" izz="{}"/></inertial>'
)


def overlays(layer: str, context, given=None) -> list[SceneItem]:
    scene = with_layers(build(context, given), context, [layer], given)
    return [item for item in scene.items if item.role == layer or item.material.overlay]


def test_the_box_of_inertia_is_the_box_that_has_it() -> None:
    x, y, z = 0.2, 0.3, 0.6  # 12 kg of it: I = m/12 (b^2 + c^2)
    tensor = SOLID.format(y * y + z * z, x * x + z * z, x * x + y * y)
    context = robot(f'<link name="a">{tensor}</link>')
    (item,) = overlays("inertia", context)
    turned_back = item.vertices - np.array((0.1, 0, 0))
    c, s = np.cos(-0.5), np.sin(-0.5)
    own = turned_back @ np.array(((c, -s, 0), (s, c, 0), (0, 0, 1))).T
    assert np.ptp(own, axis=0) == pytest.approx((x, y, z), rel=1e-4)


def test_a_box_of_inertia_larger_than_the_robot_is_reported_and_not_drawn() -> None:
    light = (
        '<inertial><mass value="0.01"/><inertia ixx="{0}" ixy="0" ixz="0" iyy="{0}" iyz="0" '
        'izz="{0}"/></inertial>'
    )
    base = link("base", '<box size="1 1 1"/>').replace("</link>", SOLID.format(2, 2, 2) + "</link>")
    frames = [f'<link name="frame{n}">{light.format(0.01)}</link>' for n in range(6)]
    context = robot(base, *frames, f'<link name="good">{light.format(1e-4)}</link>')
    scene = with_layers(build(context), context, ["inertia"])
    assert {item.link for item in scene.items if item.material.overlay} == {"base", "good"}
    assert [label.text for label in scene.labels] == [
        *(f"frame{n}: inertia of 2.45 m" for n in range(3)),
        "and of 3 more, too large to be drawn",
    ]


def test_a_tensor_that_no_matter_has_is_drawn_flat_not_refused() -> None:
    context = robot(f'<link name="a">{SOLID.format(1, 1, 5)}</link>')
    (item,) = overlays("inertia", context)
    assert np.isfinite(item.vertices).all()


def test_frames_point_where_the_axes_do() -> None:
    context = robot(link("a", '<box size="1 1 1"/>'))
    x, y, z = overlays("frames", context)
    for axis, item in enumerate((x, y, z)):
        tip = item.vertices[np.argmax(item.vertices[:, axis])]
        assert np.argmax(item.material.rgba[:3]) == axis
        assert tip == pytest.approx(np.eye(3)[axis] * tip[axis], abs=1e-3)


JOINT = (
    '<joint name="j" type="{}"><origin xyz="0 0 1"/><parent link="a"/><child link="b"/>'
    '<axis xyz="0 0 1"/><limit lower="{}" upper="{}" effort="1" velocity="1"/></joint>'
)


def test_frames_of_a_robot_without_geometry_are_seen_from_outside() -> None:
    context = robot('<link name="a"/>')
    scene = with_layers(build(context), context, ["frames"])
    camera = place_camera(scene.points(), "front")
    ends = np.concatenate([item.vertices for item in scene.items])
    assert np.linalg.norm(np.array(camera.eye)) > 3 * np.abs(ends).max()


def test_the_sector_of_a_joint_spans_its_range() -> None:
    context = robot(
        link("a", '<box size="1 1 1"/>'),
        link("b", '<box size="1 1 1"/>'),
        joints=JOINT.format("revolute", -pi / 4, pi / 2),
    )
    _, sector, hand = overlays("joints", context, {"j": pi / 4})

    def angles(item: SceneItem) -> np.ndarray:
        rim = item.vertices[1:]
        return np.arctan2(rim[:, 1], rim[:, 0])

    span = angles(sector)
    assert (span.min(), span.max()) == pytest.approx((-pi / 4, pi / 2), abs=1e-3)
    assert angles(hand).mean() == pytest.approx(pi / 4, abs=1e-3)
    assert sector.vertices[:, 2] == pytest.approx(1)


def test_the_rail_of_a_slide_is_as_long_as_its_way() -> None:
    context = robot(
        link("a", '<box size="1 1 1"/>'),
        link("b", '<box size="1 1 1"/>'),
        joints=JOINT.format("prismatic", -0.5, 1.5),
    )
    _, rail, ball = overlays("joints", context, {"j": 0.25})
    assert (rail.vertices[:, 2].min(), rail.vertices[:, 2].max()) == pytest.approx((0.5, 2.5))
    assert (ball.vertices[:, 2].min() + ball.vertices[:, 2].max()) / 2 == pytest.approx(1.25)


def test_the_centre_of_mass_is_that_of_all_links() -> None:
    mass = '<inertial><origin xyz="{} 0 0"/><mass value="{}"/></inertial>'
    context = robot(
        f'<link name="a">{mass.format(0, 1)}</link>', f'<link name="b">{mass.format(4, 3)}</link>'
    )
    scene = with_layers(build(context), context, ["mass"])
    (label,) = scene.labels
    assert label.text == "4 kg"
    assert placed(np.array([label.point]), scene.frames[label.link])[0] == pytest.approx((3, 0, 0))


def test_a_sign_is_seen_through_what_hides_it_and_throws_no_shadow() -> None:
    context = robot(link("a", '<box size="1 1 1"/>', rgba="1 1 1 1"))
    scene = with_layers(build(context), context, ["frames"])
    camera = place_camera(scene.points(), "front", size=(200, 200))
    plain, signed = alone(build(context), camera).astype(int), alone(scene, camera).astype(int)
    changed = np.abs(plain - signed).sum(axis=2) > 20
    assert 0 < changed.sum() < 0.05 * changed.size
    assert (plain[..., 3] == signed[..., 3]).mean() > 0.95


def test_contacts_are_where_boxes_overlap_and_as_deep() -> None:
    pytest.importorskip("coal")
    box = '<collision><origin xyz="{} 0 0"/><geometry><box size="1 1 1"/></geometry></collision>'
    context = robot(
        f'<link name="a">{box.format(0)}</link>',
        f'<link name="b">{box.format(0.9)}</link>',
        f'<link name="c">{box.format(1.85)}</link>',
        f'<link name="d">{box.format(5)}</link>',
        joints="".join(
            f'<joint name="{child}" type="{kind}"><parent link="a"/><child link="{child}"/></joint>'
            for child, kind in (("b", "fixed"), ("c", "continuous"), ("d", "fixed"))
        ),
    )
    scene = with_layers(build(context), context, ["contacts"])
    reported = {label.text: label.point for label in scene.labels}
    assert set(reported) == {"a, b: 100 mm", "b, c: 50 mm"}
    assert reported["a, b: 100 mm"] == pytest.approx((0.45, 0, 0), abs=1e-6)
    shown = {item.link: item.material.rgba for item in scene.items if item.label == "box"}
    assert set(shown) == {"a", "b", "c"}
    assert shown["a"] == ADJACENT
    assert shown["b"] == shown["c"] == OVERLAP
    assert [(colour[:3], text) for colour, text in scene.legend] == [
        (OVERLAP[:3], "links overlap"),
        (ADJACENT[:3], "adjacent links overlap"),
    ]
    shapes = with_layers(build(context, roles=("collision",)), context, ["contacts"])
    solid = {item.link: item.material for item in shapes.items if item.role == "contacts"}
    assert solid["a"] == SurfaceMaterial((*ADJACENT[:3], 1.0))


def test_masses_and_inertias_have_a_legend() -> None:
    context = read(ARM)
    scene = with_layers(build(context), context, ["mass", "inertia", "frames"])
    assert [(colour[:3], text) for colour, text in scene.legend] == [
        (MASS[:3], "centres of mass"),
        (ROBOT[:3], "that of the robot"),
        (INERTIA[:3], "boxes of the same inertia"),
    ]


def test_contacts_have_a_colour_that_nothing_else_has() -> None:
    for colour in (COLLISION.rgba, OVERLAP, INERTIA, PLACEHOLDER.rgba):
        apart = [abs(a - b) for a, b in zip(colour[:3], ADJACENT[:3], strict=True)]
        assert max(apart) > 0.3


def test_names_stand_beside_their_links_and_never_on_one_another() -> None:
    links = [link(f"link_{i}", '<sphere radius="0.1"/>', f"0 {i * 0.05} 0") for i in range(12)]
    context = robot(*links)
    scene = with_layers(build(context), context, ["names"])
    assert [label.text for label in scene.labels] == [f"link_{i}" for i in range(12)]
    bare = np.asarray(render_image(build(context), size=(480, 270), quality="draft"), dtype=int)
    named = np.asarray(render_image(scene, size=(480, 270), quality="draft"), dtype=int)
    assert (np.abs(bare - named).sum(axis=2) > 60).sum() > 500


def test_names_are_of_what_is_seen_and_the_others_are_counted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    written: list[str] = []

    def recorded(text: str, size: float) -> tuple[Any, str]:
        written.append(text)
        return writing(text, size)

    monkeypatch.setattr(labels, "writing", recorded)
    wall = link("wall", '<box size="0.1 4 4"/>')
    hidden = [link(f"hidden{n}", '<sphere radius="0.1"/>', "-1 0 0") for n in range(3)]
    context = robot(wall, *hidden, '<link name="bare"/>')
    scene = with_layers(build(context), context, ["names"])
    render_image(scene, ["front"], size=(480, 270), quality="draft", floor=False)
    assert written == ["wall", "4 labels not shown"]
    written.clear()
    frames = with_layers(build(context, roles=()), context, ["frames", "names"])
    render_image(frames, ["front"], size=(480, 270), quality="draft", floor=False)
    assert {"wall", "hidden0", "hidden1", "hidden2", "bare"} == set(written)


def test_names_in_a_crowd_stay_near_their_links(monkeypatch: pytest.MonkeyPatch) -> None:
    context = robot(*[link(f"link_{i}", '<sphere radius="0.01"/>') for i in range(99)])
    scene = with_layers(build(context, roles=()), context, ["frames", "names"])
    far: list[float] = []

    def leader(_draw: object, x: float, y: float, box: labels.LabelBox, size: float) -> None:
        far.append(max(box.left - x, x - box.right, box.top - y, y - box.bottom) / size)

    monkeypatch.setattr(labels, "_draw_leader", leader)
    render_image(scene, ["front"], size=(480, 270), quality="draft", floor=False)
    assert len(far) > 8
    assert max(far) < 4.1


@pytest.mark.parametrize("layer", LAYERS)
def test_every_layer_takes_a_robot_that_is_nothing(layer: str) -> None:
    context = robot('<link name="a"/>')
    render_image(with_layers(build(context), context, [layer]), size=(64, 64), quality="draft")


@pytest.mark.parametrize("layer", LAYERS)
def test_every_layer_takes_a_robot_larger_than_the_world(layer: str, tmp_path: Path) -> None:
    shape = '<geometry><box size="1e308 1e308 1e308"/></geometry>'
    inertial = '<mass value="1e308"/><inertia ixx="1e308" iyy="1e308" izz="1e308"/>'
    link = f"<inertial>{inertial}</inertial><visual>{shape}</visual><collision>{shape}</collision>"
    file = tmp_path / "r.urdf"
    file.write_text(
        f"""<robot name="r"><link name="a">{link}</link><link name="b">{link}</link>
        <joint name="j" type="revolute"><parent link="a"/><child link="b"/>
        <origin xyz="1e308 1e308 -1e308"/>
        <limit lower="-1e308" upper="1e308" effort="1" velocity="1"/></joint></robot>"""
    )
    context = read(file)
    with_layers(build(context), context, [layer])


def test_a_layer_that_is_not_there_is_named() -> None:
    context = robot('<link name="a"/>')
    with pytest.raises(NoSuchLayer, match="frames"):
        with_layers(build(context), context, ["frame"])


@pytest.mark.parametrize(
    ("layer", "note"),
    [
        ("mass", "layer 'mass' is empty: no link has a mass"),
        ("inertia", "layer 'inertia' is empty: no link has a mass"),
        ("contacts", "layer 'contacts' is empty: no links overlap"),
        ("joints", "layer 'joints' is empty: no joint moves"),
    ],
)
def test_a_layer_that_has_nothing_to_draw_says_why(layer: str, note: str) -> None:
    context = robot('<link name="a"/>', '<link name="b"/>')
    assert with_layers(build(context), context, [layer, "frames"]).notes == (note,)
