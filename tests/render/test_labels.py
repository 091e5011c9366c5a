"""Legends, captions and the scale: legible on any background, apart from one another."""

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np
from PIL import Image

from urdfkit.render.camera import place_camera
from urdfkit.render.labels import caption, write_legend
from urdfkit.render.scale import write_scale

POINTS = np.array([(0, 0, 0), (1, 1, 1)], dtype=np.float32)
RED = (1.0, 0.0, 0.0, 1.0)


@pytest.mark.parametrize("background", ["black", "#203040", "grey", "white"])
def test_words_contrast_with_the_background(background: str) -> None:
    camera = place_camera(POINTS, "front", size=(600, 300), orthographic=True)
    for write in (
        lambda image: caption(image, "front"),
        lambda image: write_scale(image, camera, 0.0),
        lambda image: write_legend(image, [(None, "error")]),
    ):
        image = Image.new("RGBA", camera.size, background)
        before = np.asarray(image.convert("L")).astype(int)
        write(image)
        assert abs(np.asarray(image.convert("L")) - before).max() > 80


def test_a_transparent_background_counts_as_white() -> None:
    image = Image.new("RGBA", (600, 300), (0, 0, 0, 0))
    caption(image, "front")
    assert np.asarray(image)[..., :3].max() < 100


def test_a_long_legend_is_continued_above_and_does_not_reach_the_scale() -> None:
    image = Image.new("RGBA", (320, 360), "white")
    entries = [(RED, "links overlap"), (RED, "adjacent links overlap"), (None, "1 label not shown")]
    write_legend(image, entries)
    ink = np.asarray(image.convert("L")) < 200
    columns = np.nonzero(ink.any(axis=0))[0]
    assert columns.min() >= 80
    assert columns.max() < 320
    squares = np.asarray(image.convert("HSV"))[..., 1] > 200
    rows = np.nonzero(squares.any(axis=1))[0]
    assert rows.max() < 345, "the last line is full"
    assert ink[rows.max() + 4 :].any()
