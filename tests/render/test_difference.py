"""The difference of two states in an image."""

import pytest

pytest.importorskip("PIL")
pytest.importorskip("numpy")

import numpy as np

from tests.render.scenes import link, scene
from urdfkit.render import difference
from urdfkit.render.difference import CHANGED, GONE, NEW

BASE = link("base", '<box size="1 1 1"/>', rgba="0.8 0.8 0.8 1")
SIZE = (600, 200)


def kinds(*pair: tuple[str, ...]) -> dict[str, int]:
    """How many pixels of the third image are of each colour."""
    before, after = (scene(*links) for links in pair)
    picture = difference(before, after, "left", size=SIZE)
    pixels = np.asarray(picture)[30:-30, 400:].astype(int)  # without the words
    found = {}
    for name, colour in (("gone", GONE), ("new", NEW), ("changed", CHANGED)):
        along = pixels / np.maximum(pixels.max(axis=2, keepdims=True), 1)
        ratio = np.array(colour[:3]) / max(colour[:3])
        found[name] = int((np.abs(along - ratio).max(axis=2) < 0.03).sum())
    return found


def test_a_robot_does_not_differ_from_itself() -> None:
    assert kinds((BASE,), (BASE,)) == {"gone": 0, "new": 0, "changed": 0}


def test_what_is_new_is_green_and_what_is_gone_is_red() -> None:
    more = link("b", '<box size="0.5 0.5 0.5"/>', "1 0 0")
    there = kinds((BASE,), (BASE, more))
    back = kinds((BASE, more), (BASE,))
    assert there["new"] > 300
    assert there["gone"] == there["changed"] == 0
    assert back["gone"] == there["new"]
    assert back["new"] == 0


def test_another_colour_is_amber() -> None:
    other = link("base", '<box size="1 1 1"/>', rgba="0.1 0.1 0.8 1")
    found = kinds((BASE,), (other,))
    assert found["changed"] > 2000
    assert found["gone"] == found["new"] == 0
