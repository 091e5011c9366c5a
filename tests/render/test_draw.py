"""Truths of geometry that an image must show."""

from itertools import product

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image, ImageDraw

from tests.render.scenes import alone, colour_at, corners, link, robot, scene
from urdfkit.render import Camera, Scene, build, draw, place_camera, render_image

BOX = '<box size="0.4 0.2 0.3"/>'
SIZE = (320, 200)


def hull(points: np.ndarray) -> list[tuple[float, float]]:
    """The convex hull of points in a plane (Andrew's monotone chain)."""
    ordered = sorted({(float(x), float(y)) for x, y in points.round(6)})
    found: list[tuple[float, float]] = []
    for run in (ordered, ordered[::-1]):
        chain: list[tuple[float, float]] = []
        for x, y in run:
            while len(chain) > 1 and (chain[-1][0] - chain[-2][0]) * (y - chain[-2][1]) <= (
                chain[-1][1] - chain[-2][1]
            ) * (x - chain[-2][0]):
                chain.pop()
            chain.append((x, y))
        found += chain[:-1]
    return found


@pytest.mark.parametrize("orthographic", [False, True])
@pytest.mark.parametrize("view", ["iso", "front", "left", "top", "bottom"])
def test_the_silhouette_of_a_box_is_the_hull_of_its_corners(view: str, orthographic: bool) -> None:
    box = scene(link("a", BOX, "1 2 3"))
    camera = place_camera(box.points(), view, size=SIZE, orthographic=orthographic)
    ends = list(product((0.8, 1.2), (1.9, 2.1), (2.85, 3.15)))
    outline = hull(corners(camera, ends))
    fine = Image.new("L", (SIZE[0] * 8, SIZE[1] * 8))
    ImageDraw.Draw(fine).polygon([(x * 8, y * 8) for x, y in outline], fill=255)
    expected = np.asarray(fine.resize(SIZE, Image.Resampling.BOX), dtype=int)
    alpha = alone(box, camera, "default")[..., 3].astype(int)
    wrong = np.abs(alpha - expected) > 255 * 0.45  # less than half a pixel
    assert not wrong.any()
    assert abs(alpha.sum() - expected.sum()) / 255 < 1.5 * sum(SIZE) * 0.05


def test_auto_framing_fills_the_image_and_cuts_nothing() -> None:
    for view, size in product(("iso", "top", "left"), ((320, 200), (100, 300))):
        box = scene(link("a", BOX, "1 2 3"), link("b", '<sphere radius="0.1"/>', "0 0 0"))
        alpha = alone(box, place_camera(box.points(), view, size=size))[..., 3]
        assert not alpha[[0, -1]].any()
        assert not alpha[:, [0, -1]].any()
        rows, columns = np.nonzero(alpha.any(1))[0], np.nonzero(alpha.any(0))[0]
        wide, high = np.ptp(columns) / size[0], np.ptp(rows) / size[1]
        assert max(wide, high) > 0.75


def test_the_nearer_box_hides_the_other_whatever_their_order() -> None:
    near = link("near", '<box size="0.1 1 1"/>', "1 0 0", "0 1 0 1")
    far = link("far", '<box size="0.1 1 1"/>', "-1 0 0", "1 0 0 1")
    for links in ((near, far), (far, near)):
        of = scene(*links)
        camera = place_camera(of.points(), "front", size=SIZE)
        assert colour_at(alone(of, camera), 160, 100) == "green"
        behind = place_camera(of.points(), "back", size=SIZE)
        assert colour_at(alone(of, behind), 160, 100) == "red"


def test_boxes_that_pass_through_one_another_meet_where_they_do() -> None:
    """Two slabs cross at 45 degrees: the left half shows the one, the right half the other."""
    of = scene(
        link("a", '<box size="0.01 2 2"/>', "0 0 0", "1 0 0 1", "0 0 0.7853981634"),
        link("b", '<box size="0.01 2 2"/>', "0 0 0", "0 1 0 1", "0 0 -0.7853981634"),
    )
    pixels = alone(of, place_camera(of.points(), "front", size=SIZE))
    middle, reach = 160, 40
    row = [colour_at(pixels, middle + step, 100) for step in (-reach, -3, 3, reach)]
    assert row in (["red", "red", "green", "green"], ["green", "green", "red", "red"])
    assert row[0] == "red"  # turned towards the left, which is +y


def test_perspective_shrinks_what_is_far_and_parallel_rays_do_not() -> None:
    of = scene(
        link("near", '<box size="0.1 0.4 0.4"/>', "2 0.5 0", "0 1 0 1"),
        link("far", '<box size="0.1 0.4 0.4"/>', "-2 -0.5 0", "1 0 0 1"),
    )

    def areas(orthographic: bool) -> tuple[int, int]:
        camera = place_camera(of.points(), "front", size=SIZE, orthographic=orthographic)
        pixels = alone(of, camera).astype(int)
        green = (pixels[..., 1] > pixels[..., 0]) & (pixels[..., 3] > 128)
        red = (pixels[..., 0] > pixels[..., 1]) & (pixels[..., 3] > 128)
        return int(green.sum()), int(red.sum())

    near, far = areas(orthographic=True)
    assert near == pytest.approx(far, rel=0.03)
    near, far = areas(orthographic=False)
    assert near > 1.3 * far


def test_left_of_the_robot_is_left_in_the_image_from_behind() -> None:
    of = scene(
        link("left", '<box size="0.2 0.2 0.2"/>', "0 1 0", "0 1 0 1"),
        link("right", '<box size="0.2 0.2 0.2"/>', "0 -1 0", "1 0 0 1"),
    )
    expected = {"back": ("green", "red"), "front": ("red", "green"), "top": ("red", "green")}
    for view, colours in expected.items():
        pixels = alone(of, place_camera(of.points(), view, size=SIZE))
        columns = np.nonzero(pixels[..., 3].any(0))[0]
        rows = np.nonzero(pixels[..., 3].any(1))[0]
        row = int(rows.mean())
        assert (
            colour_at(pixels, columns[0] + 4, row),
            colour_at(pixels, columns[-1] - 4, row),
        ) == colours, view


def test_what_lies_before_the_camera_is_cut_not_turned_inside_out() -> None:
    """A camera in the middle of a long floor sees it to the horizon, and nothing above that."""
    of = scene(link("a", '<box size="100 100 0.1"/>', "0 0 -0.05"))
    camera = Camera(
        (0.0, 0.0, 1.0), ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)), SIZE, 60.0, near=0.01
    )
    alpha = alone(of, camera)[..., 3]
    horizon = SIZE[1] / 2 + camera.scale * 1 / 50
    assert not alpha[: int(horizon) - 1].any()
    assert (alpha[int(horizon) + 2 :] == 255).all()


def test_a_shape_behind_the_camera_is_not_seen() -> None:
    of = scene(link("a", BOX, "5 0 0"))
    camera = Camera((0.0, 0.0, 0.0), ((0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 0.0)), SIZE)
    assert not alone(of, camera).any()


def test_transparent_shapes_mix_with_what_is_behind_in_the_right_order() -> None:
    glass = '<box size="0.02 1 1"/>'
    of = scene(
        link("wall", glass, "-1 0 0", "0 0 1 1"),
        link("green", glass, "0 0 0", "0 1 0 0.5"),
        link("red", glass, "1 0 0", "1 0 0 0.5"),
    )
    middle = alone(of, place_camera(of.points(), "front", size=SIZE, orthographic=True))[100, 160]
    r, g, b, a = (int(part) for part in middle)
    assert a == 255
    assert r > g > b > 20
    behind = alone(of, place_camera(of.points(), "back", size=SIZE, orthographic=True))[100, 160]
    assert behind[2] > 2 * max(behind[:2])


def test_half_a_pixel_of_a_box_is_half_its_alpha() -> None:
    of = scene(link("a", '<box size="1 1 1"/>'))
    extent = 200 / 100.5  # the box is 100.5 pixels wide and begins at a quarter of a pixel
    camera = place_camera(of.points(), "front", size=(200, 200), orthographic=True)
    alpha = alone(of, camera._replace(extent=extent), "high")[100, :, 3].astype(int)
    assert list(np.nonzero(alpha)[0][[0, -1]]) == [49, 150]
    assert alpha[49] == pytest.approx(255 / 4, abs=17)
    assert (alpha[50:150] == 255).all()


@pytest.mark.parametrize("quality", ["draft", "default"])
def test_the_bytes_do_not_depend_on_threads(quality: str) -> None:
    of = scene(
        link("a", BOX),
        link("b", '<sphere radius="0.2"/>', "0.3 0 0.2"),
        link("c", '<cylinder radius="0.1" length="0.5"/>', "0 0.3 0", "0 1 1 0.4"),
    )
    camera = place_camera(of.points(), size=(400, 300))
    one = draw(of, camera, quality=quality, threads=1)
    for threads in (2, 3):
        assert (draw(of, camera, quality=quality, threads=threads) == one).all()


def test_shadows_fall_away_from_the_sun_and_darken_the_ground() -> None:
    of = scene(link("a", '<box size="0.2 0.2 0.6"/>', "0 0 0.3"))
    camera = place_camera(of.points(), "iso", size=SIZE)
    bare, shadowed = (draw(of, camera, floor=floor)[..., :3].astype(int) for floor in (False, True))
    darker = (bare - shadowed).sum(axis=2)
    alpha = alone(of, camera)[..., 3]
    assert darker[alpha == 0].max() > 60
    rows, columns = np.nonzero((darker > 20) & (alpha == 0))
    assert columns.mean() > 160  # the sun stands at the left
    assert rows.mean() > np.nonzero(alpha.any(1))[0].mean()  # and the shadow lies at the foot


def test_an_empty_robot_is_an_empty_image() -> None:
    of = build(robot('<link name="a"/>'))
    pixels = draw(of, place_camera(of.points(), size=SIZE))
    assert np.ptp(pixels[100].astype(int), axis=0).max() <= 1  # the background is dithered
    assert not alone(of, place_camera(of.points(), size=SIZE)).any()


def test_progress_goes_from_the_first_step_to_the_last() -> None:
    reported: list[tuple[int, int]] = []
    render_image(
        scene(link("a", BOX)),
        ["front", "top"],
        size=(200, 100),
        threads=2,
        progress=lambda done, total: reported.append((done, total)),
    )
    assert sorted(reported) == [(done, reported[-1][1]) for done in range(1, reported[-1][1] + 1)]


@pytest.mark.parametrize("orthographic", [False, True])
def test_a_collision_on_its_visual_covers_it_without_patches(orthographic: bool) -> None:
    ball = '<geometry><sphere radius="0.3"/></geometry>'
    inner = '<geometry><sphere radius="0.2995"/></geometry>'  # a hair below
    body = f'<visual>{ball}<material name="m"><color rgba="0 0 1 1"/></material></visual>'
    context = robot(f'<link name="a">{body}<collision>{inner}</collision></link>')
    shown = build(context, roles=("visual", "collision"))
    camera = place_camera(shown.points(), "iso", size=SIZE, orthographic=orthographic)
    alone_, both = (alone(one, camera).astype(int) for one in (build(context), shown))
    inside = alone_[..., 3] == 255
    inside[[0, -1]] = inside[:, [0, -1]] = False
    core = inside.copy()
    for _ in range(6):  # the rim, where both are seen edge on, is left out
        core[1:-1, 1:-1] &= core[:-2, 1:-1] & core[2:, 1:-1] & core[1:-1, :-2] & core[1:-1, 2:]
    assert core.sum() > 5000
    assert (both[core][:, 0] > alone_[core][:, 0] + 20).all()  # reddish everywhere


@pytest.mark.parametrize("tilt", [-0.6, 0.0, 0.6])
def test_a_wall_that_nothing_shades_is_of_one_brightness(tilt: float) -> None:
    of = scene(link("a", '<box size="0.02 1 1"/>', rpy=f"0 {tilt} 0", rgba="0.8 0.8 0.8 1"))
    camera = place_camera(of.points(), "front", size=SIZE, orthographic=True)
    pixels = draw(of, camera, floor=False).astype(int)
    assert np.ptp(pixels[60:140, 110:210, :3], axis=(0, 1)).max() <= 1


def test_corners_are_darker_evenly_along_their_edge() -> None:
    of = scene(
        link("wall", '<box size="0.1 2 1"/>', "0 0 0.5", rgba="0.8 0.8 0.8 1"),
        link("plate", '<box size="1 2 0.1"/>', "0.5 0 0", rgba="0.8 0.8 0.8 1"),
    )
    camera = place_camera(of.points(), "front", elevation=30, size=SIZE, orthographic=True)
    rows = draw(of, camera, floor=False).astype(int)[40:160, 120:200, 1]
    assert np.ptp(rows, axis=1).max() <= 1
    wall = rows[:77, 40]
    assert np.ptp(wall[:60]) == 0
    assert wall[0] - wall[-1] > 25
    assert np.diff(wall).max() <= 0


def plate(strips: int) -> Scene:
    """A square that stands across the line of sight, cut into strips of two triangles."""
    bare = scene(link("a", '<box size="1 1 1"/>', rgba="0.5 0.5 0.5 1"))
    up = np.linspace(0, 1, strips + 1, dtype=np.float32)
    left = np.stack((0 * up, 0 * up, up), axis=1)
    first, after = np.arange(strips), strips + 1
    faces = np.concatenate(
        (
            np.stack((first, first + after, first + 1), axis=1),
            np.stack((first + 1, first + after, first + after + 1), axis=1),
        )
    )
    vertices = np.concatenate((left, left + np.array((1, -0.6, 0), dtype=np.float32)))
    item = bare.items[0]._replace(vertices=vertices, faces=faces, normals=None, uv=None)
    return bare._replace(items=(item,))


@pytest.mark.parametrize("orthographic", [False, True])
def test_slivers_look_like_the_plane_that_they_lie_in(orthographic: bool) -> None:
    """Far thinner than a pixel, they are hit beside themselves, and their corners are far away."""
    camera = place_camera(
        plate(1).points(), azimuth=60, elevation=20, size=SIZE, orthographic=orthographic
    )
    whole, cut = (draw(plate(n), camera, floor=False, threads=1).astype(int) for n in (1, 20_000))
    assert np.abs(whole - cut).max() <= 2
