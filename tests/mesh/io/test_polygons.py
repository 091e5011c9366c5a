from math import cos, pi, sin

import pytest

pytest.importorskip("numpy")
pytest.importorskip("mapbox_earcut")

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.mesh.geometry import Floats, Integers
from urdfkit.mesh.io.polygons import fans, strips, triangles

#: A dart: the last corner is a dent, and a fan about the first corner reaches outside.
DART = np.array([(2, 0, 0), (0, 2, 0), (-2, 0, 0), (0, 1, 0)], dtype=float)


def areas(places: Floats, faces: Integers) -> Floats:
    """Of triangles in the plane z = 0, positive if they are counter-clockwise from above."""
    a, b, c = (places[faces[:, i]] for i in range(3))
    found: Floats = np.cross(b - a, c - a)[:, 2] / 2
    return found


def outline(places: Floats) -> float:
    """The area of a polygon in the plane z = 0, by the shoelace formula."""
    x, y = places[:, 0], places[:, 1]
    return float((x * np.roll(y, -1) - y * np.roll(x, -1)).sum() / 2)


def test_convex_polygons_are_fans() -> None:
    square = np.array([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], dtype=float)
    places = np.concatenate([square, square[:3], square])
    assert triangles(np.array([4, 3, 4]), places).tolist() == [
        [0, 1, 2], [0, 2, 3], [4, 5, 6], [7, 8, 9], [7, 9, 10]
    ]  # fmt: skip


def test_polygons_of_fewer_corners_have_no_triangles() -> None:
    assert triangles(np.array([0, 1, 2]), np.zeros((3, 3))).shape == (0, 3)
    assert triangles(np.zeros(0, dtype=np.int64), np.zeros((0, 3))).shape == (0, 3)


@pytest.mark.parametrize("turn", range(4))
@pytest.mark.parametrize("way", [1, -1])
def test_a_dart_is_covered_once(turn: int, way: int) -> None:
    places = np.roll(DART, turn, axis=0)[::way]
    faces = triangles(np.array([4]), places)
    assert sorted(areas(places, faces) * way) == pytest.approx([1, 1])


@given(st.lists(st.floats(0.2, 1), min_size=4, max_size=12), st.booleans())
def test_stars_are_covered_once(radii: list[float], backwards: bool) -> None:
    """Their triangles look as they do, and make their area together."""
    number = len(radii)
    angles = [2 * pi * i / number for i in range(number)]
    places = np.array([(r * cos(a), r * sin(a), 0) for r, a in zip(radii, angles, strict=True)])
    if backwards:
        places = places[::-1]
    faces = triangles(np.array([number]), places)
    assert len(faces) == number - 2
    assert (areas(places, faces) * (-1 if backwards else 1) > -1e-12).all()
    assert areas(places, faces).sum() == pytest.approx(outline(places))


def test_a_dart_in_any_plane_among_other_polygons() -> None:
    upright = DART[:, [2, 0, 1]]
    places = np.concatenate([DART[:3], upright, DART[:3]])
    faces = triangles(np.array([3, 4, 3]), places)
    a, b, c = (places[faces[:, i]] for i in range(3))
    normals = np.cross(b - a, c - a)
    assert sorted(map(tuple, faces[:2].tolist())) == [(0, 1, 2), (7, 8, 9)]
    assert normals[2:].tolist() == [[2, 0, 0], [2, 0, 0]]


@pytest.mark.parametrize("bad", [float("nan"), float("inf"), 1e300])
def test_corners_that_are_nowhere(bad: float) -> None:
    places = DART.copy()
    places[1, 1] = bad
    assert len(triangles(np.array([4]), places)) == 2


def test_strips_look_one_way() -> None:
    places = np.array([(0, 0, 0), (1, 0, 0), (0, 1, 0), (1, 1, 0), (0, 2, 0)], dtype=float)
    assert (areas(places, strips(np.array([5]))) > 0).all()
    assert fans(np.array([5])).tolist() == [[0, 1, 2], [0, 2, 3], [0, 3, 4]]
