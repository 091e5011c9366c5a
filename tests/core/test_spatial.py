"""Frames and rotations, compared with scipy and with what defines them."""

from itertools import product
from math import hypot, isclose, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.core.spatial import (
    IDENTITY,
    Rotation,
    Transform,
    cross,
    dot,
    from_rpy,
    minus,
    multiply,
    rotate,
    to_rpy,
    transposed,
)

angles = st.floats(-2 * pi, 2 * pi)
lengths = st.floats(-100, 100)
vectors = st.tuples(lengths, lengths, lengths)
turns = st.one_of(st.just(IDENTITY), st.builds(from_rpy, angles, angles, angles))
frames = st.builds(Transform, turns, vectors)


def near(expected: object) -> object:
    return pytest.approx(expected, abs=1e-9)


def rows(rotation: Rotation) -> list[float]:
    return [value for row in rotation for value in row]


@given(angles, angles, angles)
def test_rpy_turns_about_the_fixed_axes(roll: float, pitch: float, yaw: float) -> None:
    transform = pytest.importorskip("scipy.spatial.transform")
    expected = transform.Rotation.from_euler("xyz", (roll, pitch, yaw)).as_matrix()
    assert rows(from_rpy(roll, pitch, yaw)) == near(expected.ravel().tolist())


def test_quarter_turns() -> None:
    x, y, z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)
    for turn, axis, moved, to in (
        ((pi / 2, 0, 0), x, y, z),
        ((0, pi / 2, 0), y, z, x),
        ((0, 0, pi / 2), z, x, y),
    ):
        rotation = from_rpy(*turn)
        assert rotate(rotation, axis) == near(axis)
        assert rotate(rotation, moved) == near(to)


@given(st.one_of(turns, st.builds(from_rpy, angles, st.sampled_from([pi / 2, -pi / 2]), angles)))
def test_rpy_of_a_rotation_gives_it_again(rotation: Rotation) -> None:
    roll, pitch, yaw = to_rpy(rotation)
    assert rows(from_rpy(roll, pitch, yaw)) == pytest.approx(rows(rotation), abs=1e-8)
    assert abs(pitch) <= pi / 2 + 1e-12
    if isclose(abs(pitch), pi / 2, abs_tol=1e-10):
        assert yaw == 0


@given(turns, turns)
def test_a_product_is_one_turn_after_the_other(left: Rotation, right: Rotation) -> None:
    expected = [
        sum(left[row][k] * right[k][column] for k in range(3))
        for row, column in product(range(3), repeat=2)
    ]
    assert rows(multiply(left, right)) == near(expected)
    assert rows(multiply(left, transposed(left))) == near(rows(IDENTITY))


@given(frames, frames, vectors)
def test_frames_are_applied_from_the_inside_out(
    outer: Transform, inner: Transform, point: tuple[float, float, float]
) -> None:
    assert (outer @ inner).apply(point) == near(outer.apply(inner.apply(point)))
    assert outer.apply((0.0, 0.0, 0.0)) == outer.position
    there = outer.apply(point)
    assert outer.inverse.apply(there) == near(point)
    assert minus(there, outer.position) == near(rotate(outer.rotation, point))


@given(vectors, vectors)
def test_products_of_vectors(a: tuple[float, float, float], b: tuple[float, float, float]) -> None:
    made = cross(a, b)
    size = hypot(*a) * hypot(*b)
    assert dot(made, a) == pytest.approx(0, abs=1e-12 + 1e-9 * size * hypot(*a))
    assert dot(made, b) == pytest.approx(0, abs=1e-12 + 1e-9 * size * hypot(*b))
    assert dot(made, made) + dot(a, b) ** 2 == pytest.approx(
        size**2, rel=1e-9, abs=1e-12
    )  # Lagrange
    assert cross((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)) == (0, 0, 1)
    assert minus(a, b) == tuple(one - other for one, other in zip(a, b, strict=True))
