"""Closed forms against coal, and boxes around bodies as bounds."""

from math import pi, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.core.spatial import Transform, from_rpy, transposed
from urdfkit.physics.collision.closed_forms import box_distance, point_distance, signed_distance

Shape = tuple[str, tuple[float, ...]]

#: coal iterates to a tolerance of 1e-6, and loses some of it for round bodies.
NEAR = 1e-4

lengths = st.floats(0.02, 1.0)
boxes = st.tuples(st.just("box"), st.tuples(lengths, lengths, lengths))
spheres = st.tuples(st.just("sphere"), st.tuples(lengths))
long = st.tuples(st.sampled_from(["cylinder", "capsule"]), st.tuples(lengths, lengths))
shapes = st.one_of(boxes, spheres, long)
offsets = st.tuples(*[st.floats(-1.0, 1.0)] * 3)
#: With right angles, at which axes are parallel.
angles = st.one_of(st.sampled_from([0.0, pi / 2, pi, -pi / 2]), st.floats(-pi, pi))
frames = st.builds(
    lambda xyz, rpy: Transform(from_rpy(*rpy), xyz), offsets, st.tuples(angles, angles, angles)
)


def by_coal(first: Shape, second: Shape, at: Transform) -> float:
    coal = pytest.importorskip("coal")
    np = pytest.importorskip("numpy")
    kinds = {
        "box": coal.Box, "sphere": coal.Sphere, "cylinder": coal.Cylinder, "capsule": coal.Capsule,
    }  # fmt: skip
    one, other = (kinds[kind](*size) for kind, size in (first, second))
    place = coal.Transform3s(np.array(at.rotation), np.array(at.position))
    found = coal.DistanceResult()
    coal.distance(one, coal.Transform3s(), other, place, coal.DistanceRequest(), found)
    return float(found.min_distance)


def half(shape: Shape) -> tuple[float, float, float]:
    kind, size = shape
    if kind == "box":
        return (size[0] / 2, size[1] / 2, size[2] / 2)
    if kind == "sphere":
        return (size[0], size[0], size[0])
    return (size[0], size[0], size[1] / 2 + (size[0] if kind == "capsule" else 0))


@given(shapes, shapes, frames)
def test_closed_forms_agree_with_coal(first: Shape, second: Shape, at: Transform) -> None:
    found = signed_distance(*first, *second, at)
    if found is None:
        assert {first[0], second[0]} & {"cylinder", "capsule"}
        return
    exact = by_coal(first, second, at)
    if first[0] == second[0] == "box" and exact > NEAR:
        assert 0 < found <= exact + NEAR
    elif found < -NEAR:
        # Where coal's search ends too early it is too deep, never too shallow.
        assert exact <= found + NEAR
    else:
        assert found == pytest.approx(exact, abs=NEAR)


@given(shapes, shapes, frames)
def test_boxes_around_bodies_are_no_farther_apart_than_these(
    first: Shape, second: Shape, at: Transform
) -> None:
    bound = box_distance(half(first), half(second), at)
    exact = signed_distance(*first, *second, at)
    if exact is not None and exact < 0:
        assert bound <= exact + 1e-9
    else:  # coal is reliable for bodies that are apart
        assert bound <= max(by_coal(first, second, at), 0.0) + NEAR


@given(shapes, shapes, frames)
def test_a_closed_form_does_not_depend_on_the_order(
    first: Shape, second: Shape, at: Transform
) -> None:
    found = signed_distance(*first, *second, at)
    swapped = signed_distance(*second, *first, at.inverse)
    if found is None or swapped is None:
        assert found is swapped
    else:
        assert swapped == pytest.approx(found, abs=1e-7)  # axes may be nearly parallel


@pytest.mark.parametrize(
    ("first", "second", "at", "expected"),
    [
        (("sphere", (1,)), ("sphere", (2,)), (2.5, 0, 0), -0.5),
        (("cylinder", (0.2, 0.6)), ("sphere", (0.2,)), (0, 0, 0.3), -0.2),  # coal says -0.4
        (("cylinder", (0.2, 0.6)), ("sphere", (0.1,)), (0.5, 0, 0.7), sqrt(0.25) - 0.1),
        (("box", (2, 2, 2)), ("sphere", (0.5,)), (0, 0, 0.8), -0.7),
        (("box", (2, 2, 2)), ("cylinder", (0.5, 1)), (0, 0, 1.4), -0.1),
        (("box", (2, 2, 2)), ("cylinder", (0.5, 9)), (1.3, 1.4, 0), 0.0),
        (("cylinder", (0.3, 1)), ("cylinder", (0.3, 1)), (0, 0.5, 0.2), -0.1),
        (("box", (1, 1, 1)), ("box", (1, 1, 1)), (0.9, 0.2, 0), -0.1),
        (("box", (1, 1, 1)), ("capsule", (0.1, 1)), (0, 0, 0), None),
    ],
)
def test_values(
    first: Shape, second: Shape, at: tuple[float, float, float], expected: float | None
) -> None:
    found = signed_distance(*first, *second, Transform(position=at))
    assert found == (expected if expected is None else pytest.approx(expected, abs=1e-12))


def test_inclined_cylinders_have_no_closed_form_and_nearly_parallel_ones_have() -> None:
    shapes = ("cylinder", (0.1, 1.0)), ("cylinder", (0.1, 1.0))
    for angle, has_one in ((1e-3, False), (1e-7, True), (pi - 1e-7, True)):
        at = Transform(from_rpy(angle, 0, 0), (0.15, 0, 0))
        assert (signed_distance(*shapes[0], *shapes[1], at) is not None) is has_one


@pytest.mark.parametrize("gap", [0.1, -0.1])
def test_edges_that_cross(gap: float) -> None:
    """No normal of the two boxes shows how far they are apart: the axis across their edges does."""
    s = sqrt(0.5)
    axes = ((s, -s, 0.0), (0.5, 0.5, s), (-0.5, -0.5, s))
    at = Transform(transposed(axes), (2 + s * gap, 2 + s * gap, 0))
    assert box_distance((1, 1, 1), (1, 1, 1), at) == pytest.approx(gap)


def test_points() -> None:
    assert point_distance("box", (2, 2, 2), (0.9, 0, 0)) == pytest.approx(-0.1)
    assert point_distance("cylinder", (1, 2), (0, 0.5, 0.9)) == pytest.approx(-0.1)
    assert point_distance("capsule", (1, 2), (0, 0, 1.5)) == pytest.approx(-0.5)
    assert point_distance("sphere", (1,), (0, 0, 3)) == pytest.approx(2)


@pytest.mark.parametrize("kind", ["box", "sphere", "cylinder", "capsule"])
def test_a_mesh_has_no_closed_form(kind: str) -> None:
    size, at = (0.1, 0.1, 0.1), Transform()
    assert signed_distance("mesh", (), kind, size, at) is None
    assert signed_distance(kind, size, "mesh", (), at) is None
