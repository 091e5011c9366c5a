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
    pixels = np.asarray(picture)[30:-60, 400:].astype(int)  # without the words
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
    assert there["new"] > 200
    assert there["gone"] == there["changed"] == 0
    assert back["gone"] == there["new"]
    assert back["new"] == 0


def test_another_colour_is_amber() -> None:
    other = link("base", '<box size="1 1 1"/>', rgba="0.1 0.1 0.8 1")
    found = kinds((BASE,), (other,))
    assert found["changed"] > 2000
    assert found["gone"] == found["new"] == 0


WHEEL = '<cylinder radius="{}" length="0.3"/>'


def third(before: str, after: str, view: str = "iso") -> np.ndarray:
    """The image of the difference of two robots of one link each, with a base that stays."""
    picture = difference(scene(BASE, before), scene(BASE, after), view, size=SIZE)
    return np.asarray(picture)[:, 400:].astype(int)


def is_amber(pixels: np.ndarray) -> np.ndarray:
    """True for pixels that are amber, however dark."""
    red, green, blue = pixels[..., 0], pixels[..., 1], pixels[..., 2]
    return (blue < 0.2 * red) & (abs(green - 0.67 * red) < 0.06 * red)


def test_a_surface_that_moved_is_amber_as_a_whole_whatever_the_light() -> None:
    """The mantle of a wheel that grew has the colours of the old one in places."""
    small, large = (
        link("w", WHEEL.format(r), "0.8 0 0", "0.1 0.1 0.1 1", "1.5708 0 0") for r in (0.5, 0.55)
    )
    image = third(small, large)
    rows, columns = np.nonzero(is_amber(image))
    assert len(rows) > 800
    for row in np.unique(rows)[10:-10]:  # in each row one piece: no patches
        places = columns[rows == row]
        steps = np.diff(places) > 2
        assert steps.sum() <= 1


def test_shadows_are_no_difference() -> None:
    """A roof far above the base moves: the base, on which its shadow falls, stays."""
    roofs = [link("r", '<box size="1.2 1.2 0.02"/>', f"{x} 0 1.5") for x in (0, 0.3)]
    image = third(*roofs)
    assert not is_amber(image[100:180]).any()


def test_edges_within_the_robot_are_smooth() -> None:
    dark, blue = (
        link("s", '<box size="0.02 0.5 0.5"/>', "0.7 0 0", f"0 0 {part} 1", "0.3 0 0")
        for part in (0, 1)
    )
    image = third(dark, blue, "front")
    channel = image[50:150, 50:150, 2]
    mixed = (channel > 40) & (channel < 150)
    assert (channel <= 40).sum() > 1000  # of the slab
    assert mixed.sum() > 60  # on its edges


def test_the_difference_has_the_grid_and_its_scale() -> None:
    images = [
        np.asarray(difference(scene(BASE), scene(BASE), size=SIZE, floor=floor))[:, 400:]
        for floor in (True, False)
    ]
    changed = images[0] != images[1]
    assert changed[150:180, 75:].any()  # lines
    assert changed[182:, :70].any()  # its scale
