"""The scale of an image: the grid on the ground, the bar, sheets of one scale."""

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from tests.render.scenes import link, robot, scene
from urdfkit.render import build, draw, image, place_camera, render_image, with_layers
from urdfkit.render.ground import CELLS, Ground
from urdfkit.render.scale import grid_step, write_scale

ROUND = (1.0, 2.0, 5.0)


@pytest.mark.parametrize("size", [0.0004, 0.03, 1, 7, 250])
def test_the_step_of_the_grid_is_round_and_a_fraction_of_the_robot(size: float) -> None:
    points = np.array([(0, 0, 0), (size, size, size)], dtype=np.float32)
    step = grid_step(place_camera(points), 0.0)
    power = 10.0 ** np.floor(np.log10(step) + 1e-9)
    assert min(abs(step / power - one) for one in ROUND) < 1e-9
    assert size / 20 < step < size


def test_there_is_a_grid_only_where_the_camera_looks_down_on_the_ground() -> None:
    points = np.array([(0, 0, 0), (1, 1, 1)], dtype=np.float32)
    assert grid_step(place_camera(points), 0.0) > 0
    assert grid_step(place_camera(points, "front"), 0.0) == 0
    assert grid_step(place_camera(points, elevation=-30), 0.0) == 0
    assert grid_step(place_camera(points, orthographic=True), 0.0) == 0


LINKS = [f'<link name="{name}"/>' for name in "abc"]
ARM = "".join(
    f'<joint name="{child}" type="fixed"><parent link="{parent}"/><child link="{child}"/>'
    '<origin xyz="1 0.4 0.2"/></joint>'
    for parent, child in ("ab", "bc")
)
GLASS = link("a", '<box size="1 1 1"/>', rgba="0 0 1 0.5")


@pytest.mark.parametrize("is_glass", [False, True])
def test_there_is_a_grid_without_anything_opaque(is_glass: bool) -> None:
    frames = robot(*LINKS, joints=ARM)
    of = scene(GLASS) if is_glass else with_layers(build(frames, roles=()), frames, ["frames"])
    camera = place_camera(of.points(), size=(320, 180))
    with_grid, without = (draw(of, camera, quality="draft", floor=floor) for floor in (True, False))
    darker = (with_grid.astype(int) - without)[..., 0] < -5
    assert grid_step(camera, of.level()) > 0
    assert 0.005 < darker.mean() < 0.3


def test_what_is_drawn_without_a_robot_is_in_the_middle_of_the_image() -> None:
    frames = robot(*LINKS, joints=ARM)
    of = with_layers(build(frames, roles=()), frames, ["frames"])
    camera = place_camera(of.points(), size=(320, 180))
    alpha = draw(of, camera, quality="draft", background=None, floor=False)[..., 3]
    rows, columns = np.nonzero(alpha)
    for places, length in ((rows, 180), (columns, 320)):
        assert places.min() > 0
        assert places.max() < length - 1
        assert (places.min() + places.max()) / 2 == pytest.approx(length / 2, rel=0.1)


def test_lines_of_the_grid_are_at_multiples_of_its_step() -> None:
    """Seen straight from above, where the places of lines in pixels are known."""
    points = np.array([(-1, -0.7, 0), (1, 1, 0)], dtype=np.float32)
    camera = place_camera(points, "top", distance=8.0, size=(400, 300))
    shade = np.zeros((CELLS, CELLS), dtype=np.float32)
    _, dark = Ground(0.0, (-5.0, -5.0), 10 / CELLS, shade, 0.5).render_band(camera, 0, 300)
    scale = camera.scale / camera.eye[2]
    for axis, along, middle in ((1, dark[150], 200), (0, dark[:, 200], 150)):
        (lines,) = np.nonzero(
            (along > 0) & (along >= np.roll(along, 1)) & (along > np.roll(along, -1))
        )
        places = camera.eye[axis] + (lines + 0.5 - middle) / scale
        assert len(lines) >= 3
        assert np.abs(places / 0.5 - np.rint(places / 0.5)).max() * 0.5 * scale < 1


def test_the_bar_is_as_long_as_it_says() -> None:
    points = np.array([(0, 0, 0), (1, 1, 1)], dtype=np.float32)
    camera = place_camera(points, "front", size=(600, 300), orthographic=True)
    image = Image.new("RGBA", camera.size, (255, 255, 255, 255))
    write_scale(image, camera, 0.0)
    ink = np.asarray(image.convert("L")) < 128
    longest = int(ink.sum(axis=1).max())
    metres = longest / camera.scale
    assert min(abs(metres - one) for one in (0.1, 0.2, 0.5)) < 2 / camera.scale


def test_views_of_a_sheet_have_one_scale() -> None:
    """The pole would fill the view from above if it had a scale of its own."""
    pole = scene(link("a", '<box size="0.2 0.2 2"/>', rgba="0 0 0 1"))
    sheet = render_image(pole, ["iso", "front", "top", "left"], size=(800, 800), floor=False)
    grey = np.asarray(sheet.convert("L"))
    front, top, left = (
        int((grey[y + 40 : y + 390, x + 5 : x + 390] < 100).sum(axis=1).max())
        for x, y in ((400, 0), (0, 400), (400, 400))
    )
    assert front > 15
    assert front == pytest.approx(top, abs=1)
    assert front == pytest.approx(left, abs=1)


@pytest.mark.parametrize(
    ("count", "grid"), [(1, (1, 1)), (2, (2, 1)), (3, (2, 2)), (4, (2, 2)), (7, (4, 2))]
)
def test_a_sheet_has_few_empty_cells(count: int, grid: tuple[int, int]) -> None:
    assert image._grid(count) == grid
