"""Animations: what moves, what stays, and how they are saved."""

from math import pi
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from tests.conftest import ARM, MISSION
from tests.render.scenes import alone, link, scene
from urdfkit.lint.loading import read
from urdfkit.render import (
    animated,
    animation,
    build,
    followed,
    orbit,
    place_camera,
    save_animation,
    sweep,
    swept_circle,
)
from urdfkit.render.animation import AnimationError
from urdfkit.render.image import render_view

SIZE = (96, 64)


def test_a_turn_shows_every_side_and_cuts_nothing() -> None:
    of = scene(
        link("a", '<box size="1 0.2 0.2"/>'),
        link("b", '<box size="0.1 0.1 0.1"/>', "0.6 0 0", "0 0 1 1"),
    )
    camera = place_camera(swept_circle(of.points()), "front", size=SIZE)
    shots = orbit(of, camera, 4)
    wide = []
    for around, view in shots:
        alpha = alone(around, view)[..., 3]
        assert not alpha[[0, -1]].any()
        assert not alpha[:, [0, -1]].any()
        wide.append(int(alpha.any(0).sum()))
    assert wide[0] == pytest.approx(wide[2], abs=0.4 * wide[0])
    assert wide[1] == pytest.approx(wide[3], abs=1)
    assert wide[1] > 2 * wide[0]
    # A camera that went to the robot's left has its front, +x, at its own left.
    blue = [pixels[..., 2] > 2 * pixels[..., 0].astype(int) for pixels in (alone(*shots[1]),)]
    assert np.nonzero(blue[0].any(0))[0].mean() < SIZE[0] / 2


def test_a_sweep_goes_from_the_lower_limit_to_the_upper_one_and_back() -> None:
    robot = read(ARM)
    limit = robot.model.joints_by_name["elbow"].limit
    assert limit is not None
    assert limit.lower is not None
    assert limit.upper is not None
    way = [at["elbow"] for _, at in sweep(build(robot), robot, "elbow", frames=8)]
    assert way[0] == pytest.approx(limit.lower.value)
    assert way[4] == pytest.approx(limit.upper.value)
    assert way[1:4] == pytest.approx(way[:4:-1])
    assert sorted(way[:5]) == way[:5]


def test_the_way_back_of_a_sweep_is_not_drawn_again(monkeypatch: pytest.MonkeyPatch) -> None:
    robot = read(ARM)
    drawn = []

    def counted(*words: Any, **drawing: Any) -> Image.Image:
        drawn.append(words)
        return render_view(*words, **drawing)

    monkeypatch.setattr(animation, "render_view", counted)
    shots = followed(list(sweep(build(robot), robot, "elbow", frames=6)), size=(64, 40))
    images = animated(shots)
    assert (len(images), len(drawn)) == (6, 4)
    assert images[1] is images[5]
    assert images[2] is images[4]


def test_a_joint_without_limits_makes_one_turn() -> None:
    robot = read(MISSION)
    way = [at["base_to_wheel1"] for _, at in sweep(build(robot), robot, "base_to_wheel1", frames=4)]
    assert way == pytest.approx([0, pi / 2, pi, 3 * pi / 2])


def test_all_of_a_sweep_is_in_view_and_the_floor_stays() -> None:
    robot = read(ARM)
    shots = followed(list(sweep(build(robot), robot, "elbow", frames=6)), size=SIZE)
    assert len({camera for _, camera in shots}) == 1
    for posed, camera in shots:
        alpha = alone(posed, camera)[..., 3]
        assert not alpha[[0, -1]].any()
        assert not alpha[:, [0, -1]].any()


@pytest.mark.parametrize("joint", ["knee", "mount_joint", ""])
def test_what_does_not_sweep_is_said(joint: str) -> None:
    robot = read(ARM)
    with pytest.raises(AnimationError):
        list(sweep(build(robot), robot, joint))


@pytest.mark.parametrize("suffix", ["gif", "webp", "apng"])
def test_an_animation_has_its_images_and_the_same_bytes_twice(suffix: str, tmp_path: Path) -> None:
    robot = read(ARM)
    scenes = list(sweep(build(robot), robot, "elbow", frames=4))
    reported: list[tuple[int, int]] = []
    images = animated(
        followed(scenes, size=SIZE),
        quality="draft",
        progress=lambda done, of: reported.append((done, of)),
    )
    assert reported == [(1, 4), (2, 4), (3, 4), (4, 4)]
    paths = [tmp_path / f"{name}.{suffix}" for name in "ab"]
    for path in paths:
        save_animation(images, path)
    assert paths[0].read_bytes() == paths[1].read_bytes()
    with Image.open(paths[0]) as image:
        assert getattr(image, "n_frames", 1) == 4
        assert image.size == SIZE
