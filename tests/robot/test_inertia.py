from math import cos, isclose, pi, sin
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from urdfkit.core.spatial import IDENTITY, Vector, cross, dot, from_rpy, rotate
from urdfkit.robot import inertia
from urdfkit.robot.inertia import ZERO, MassProperties, principal_axes, principal_moments, rotated
from urdfkit.robot.link import Tensor

Moments = tuple[float, float, float]

angles = st.floats(-pi, pi)
rotations = st.builds(from_rpy, angles, angles, angles)
entries = st.floats(-1, 1)
symmetric = st.builds(Tensor, *[entries] * 6)
scales = st.floats(-38, 10).map(lambda exponent: 10.0**exponent)
moments = st.tuples(*[st.floats(0, 1)] * 3)
lengths = st.floats(1e-4, 10)
masses = st.floats(1e-6, 1e3)
points = st.tuples(*[st.floats(-10, 10)] * 3)


def diagonal(values: Moments) -> Tensor:
    return Tensor(values[0], 0, 0, values[1], 0, values[2])


def determinant(tensor: Tensor) -> float:
    a, b, c, d, e, f = tensor
    return a * (d * f - e * e) - b * (b * f - c * e) + c * (b * e - c * d)


def close(one: Tensor, other: Tensor, tolerance: float = 1e-12) -> bool:
    size = max(map(abs, (*one, *other)))
    return all(abs(a - b) <= tolerance * size for a, b in zip(one, other, strict=True))


def same(one: Moments, other: Moments, size: float) -> bool:
    """Equal to a few units in the last place of the largest entry of the tensor."""
    return all(abs(a - b) <= 2e-14 * size for a, b in zip(one, other, strict=True))


@given(symmetric)
def test_principal_moments_keep_order_trace_and_determinant(tensor: Tensor) -> None:
    low, middle, high = principal_moments(tensor)
    assert low <= middle <= high
    assert isclose(low + middle + high, tensor.ixx + tensor.iyy + tensor.izz, abs_tol=1e-14)
    assert isclose(low * middle * high, determinant(tensor), abs_tol=1e-14)


@given(moments, rotations)
def test_principal_moments_do_not_depend_on_the_axes(values: Moments, rotation: Any) -> None:
    low, middle, high = sorted(values)
    turned = rotated(diagonal(values), rotation)
    assert same(principal_moments(turned), (low, middle, high), 1.0)


@given(symmetric, scales)
def test_principal_moments_of_any_magnitude(tensor: Tensor, scale: float) -> None:
    small, large = principal_moments(tensor), principal_moments(inertia.scaled(tensor, scale))
    size = max(map(abs, tensor)) * scale
    assert same(large, (small[0] * scale, small[1] * scale, small[2] * scale), size)


@given(st.floats(0, 1), st.floats(0, 1), st.floats(-16, -5), rotations)
def test_principal_moments_that_nearly_coincide(
    one: float, other: float, exponent: float, rotation: Any
) -> None:
    values = (one, one * (1 + 10**exponent), other)
    low, middle, high = sorted(values)
    assert same(principal_moments(rotated(diagonal(values), rotation)), (low, middle, high), 1.0)


def test_principal_moments_of_special_tensors() -> None:
    assert principal_moments(ZERO) == (0, 0, 0)
    assert principal_moments(Tensor(3, 0, 0, 1, 0, 2)) == (1, 2, 3)
    assert principal_moments(Tensor(1, 1, 1, 1, 1, 1)) == pytest.approx((0, 0, 3), abs=1e-15)
    assert principal_moments(Tensor(0, 1, 0, 0, 0, 0)) == pytest.approx((-1, 0, 1))
    assert principal_moments(Tensor(1e-38, 5e-39, 0, 1e-38, 0, 2e-38)) == pytest.approx(
        (5e-39, 1.5e-38, 2e-38), rel=1e-13, abs=0
    )
    assert principal_moments(Tensor(1, 1e-160, 0, 1, 1e-160, 1)) == (1, 1, 1)


@given(st.builds(Tensor, *[st.floats(allow_nan=True, allow_infinity=True)] * 6))
def test_principal_moments_of_anything_are_three_numbers(tensor: Tensor) -> None:
    assert len(principal_moments(tensor)) == 3


@given(symmetric, scales)
def test_principal_moments_as_numpy_has_them(tensor: Tensor, scale: float) -> None:
    numpy = pytest.importorskip("numpy")
    a, b, c, d, e, f = inertia.scaled(tensor, scale)
    theirs = tuple(numpy.linalg.eigvalsh([[a, b, c], [b, d, e], [c, e, f]]))
    assert same(principal_moments(Tensor(a, b, c, d, e, f)), theirs, max(map(abs, tensor)) * scale)


def test_closed_forms() -> None:
    assert inertia.box(12, (1, 2, 3)) == Tensor(13, 0, 0, 10, 0, 5)
    assert inertia.cylinder(12, 1, 2) == Tensor(7, 0, 0, 7, 0, 6)
    assert inertia.sphere(5, 2) == Tensor(8, 0, 0, 8, 0, 8)
    assert inertia.capsule(5, 2, 0) == inertia.sphere(5, 2)


@given(masses, lengths)
def test_a_long_capsule_is_a_cylinder(mass: float, length: float) -> None:
    radius = length * 1e-7
    assert close(
        inertia.capsule(mass, radius, length), inertia.cylinder(mass, radius, length), 1e-6
    )


@given(masses, lengths, lengths, lengths)
def test_closed_forms_as_pinocchio_has_them(mass: float, a: float, b: float, c: float) -> None:
    pinocchio = pytest.importorskip("pinocchio")

    def theirs(body: Any) -> Tensor:
        rows = body.inertia
        return Tensor(rows[0, 0], rows[0, 1], rows[0, 2], rows[1, 1], rows[1, 2], rows[2, 2])

    shapes = pinocchio.Inertia
    assert close(inertia.box(mass, (a, b, c)), theirs(shapes.FromBox(mass, a, b, c)))
    assert close(inertia.cylinder(mass, a, b), theirs(shapes.FromCylinder(mass, a, b)))
    assert close(inertia.sphere(mass, a), theirs(shapes.FromSphere(mass, a)))
    assert close(inertia.capsule(mass, a, b), theirs(shapes.FromCapsule(mass, a, b)))


def test_the_capsule_by_adding_up_slices() -> None:
    radius, length, steps = 0.3, 0.8, 20_000
    half = length / 2 + radius
    volume = across = along = 0.0
    for step in range(steps):
        z = -half + (step + 0.5) * 2 * half / steps
        beyond = max(abs(z) - length / 2, 0.0)
        area = pi * (radius * radius - beyond * beyond)
        slab = area * 2 * half / steps
        volume += slab
        along += slab * area / pi / 2
        across += slab * (area / pi / 4 + z * z)
    expected = inertia.capsule(1.0, radius, length)
    assert expected.izz == pytest.approx(along / volume, rel=1e-6)
    assert expected.ixx == pytest.approx(across / volume, rel=1e-6)


@given(symmetric, masses, points)
def test_shifting_there_and_back(tensor: Tensor, mass: float, offset: Vector) -> None:
    there = inertia.shifted(tensor, mass, offset)
    back = inertia.shifted(there, -mass, offset)
    size = max(1.0, *map(abs, there))
    assert all(abs(a - b) <= 1e-13 * size for a, b in zip(back, tensor, strict=True))


def test_shifting_adds_the_mass_by_the_square_of_the_distance() -> None:
    assert inertia.shifted(ZERO, 2, (3, 0, 0)) == Tensor(0, 0, 0, 18, 0, 18)
    assert inertia.shifted(ZERO, 1, (1, 2, 3)) == Tensor(13, -2, -3, 10, -6, 5)


@given(symmetric, rotations)
def test_rotation_keeps_the_energy_of_every_turn(tensor: Tensor, rotation: Any) -> None:
    """w I w is the same whether tensor and w are turned or not."""
    turned = rotated(tensor, rotation)
    for w in ((1.0, 0.0, 0.0), (0.6, -0.8, 0.0), (0.1, 0.2, 0.3)):
        assert isclose(energy(turned, rotate(rotation, w)), energy(tensor, w), abs_tol=1e-13)


def energy(tensor: Tensor, w: Vector) -> float:
    a, b, c, d, e, f = tensor
    x, y, z = w
    return a * x * x + d * y * y + f * z * z + 2 * (b * x * y + c * x * z + e * y * z)


def test_rotation_by_a_quarter() -> None:
    tensor = Tensor(1, 0.1, 0.2, 2, 0.3, 3)
    assert close(rotated(tensor, from_rpy(0, 0, pi / 2)), Tensor(2, -0.1, -0.3, 1, 0.2, 3))
    assert rotated(tensor, IDENTITY) == tensor


def test_two_halves_of_a_box_are_the_box() -> None:
    half = inertia.box(3, (1, 2, 3))
    halves = [MassProperties(3, (x, 5, 6), half) for x in (-0.5, 0.5)]
    whole = inertia.combined(halves)
    assert (whole.mass, whole.center) == (6, (0, 5, 6))
    assert close(whole.tensor, inertia.box(6, (2, 2, 3)))


def test_two_points_on_a_rod() -> None:
    ends = [MassProperties(1, (cos(0.3), sin(0.3), 0), ZERO), MassProperties(1, (0, 0, 0), ZERO)]
    assert principal_moments(inertia.combined(ends).tensor) == pytest.approx((0, 0.5, 0.5))


def test_nothing_combined_is_nothing() -> None:
    assert inertia.combined([]) == MassProperties(0, (0, 0, 0), ZERO)
    frames = [MassProperties(0, (1, 2, 3), ZERO)]
    assert inertia.combined(frames) == MassProperties(0, (0, 0, 0), ZERO)


def test_a_tensor_without_mass_counts_where_the_others_balance() -> None:
    bodies = [
        MassProperties(2, (1, 0, 0), ZERO),
        MassProperties(0, (9, 9, 9), Tensor(1, 0, 0, 1, 0, 1)),
    ]
    assert inertia.combined(bodies) == MassProperties(2, (1, 0, 0), Tensor(1, 0, 0, 1, 0, 1))


def test_agreement_is_of_positive_moments_in_both_directions() -> None:
    one = diagonal((1, 2, 3))
    assert inertia.agree(one, diagonal((1.1, 2, 3)), 1.1)
    assert inertia.agree(diagonal((1.1, 2, 3)), one, 1.1)
    assert not inertia.agree(one, diagonal((1.2, 2, 3)), 1.1)
    assert not inertia.agree(one, diagonal((1, 2, -3)), 1.1)
    assert not inertia.agree(ZERO, ZERO, 2)


@given(symmetric, scales)
def test_principal_axes_make_the_tensor_again(tensor: Tensor, scale: float) -> None:
    """``R diag(moments) R^T`` along axes that are a rotation."""
    scaled = inertia.scaled(tensor, scale)
    found, axes = principal_axes(scaled)
    assert found == principal_moments(scaled)
    assert close(rotated(diagonal(found), axes), scaled, 1e-12)
    x, y, z = zip(*axes, strict=True)
    for one, other, product in ((x, x, 1), (y, y, 1), (z, z, 1), (x, y, 0), (y, z, 0), (x, z, 0)):
        assert abs(dot(one, other) - product) < 1e-13
    assert dot(cross(x, y), z) > 0


@pytest.mark.parametrize(
    ("tensor", "axes"),
    [
        (Tensor(1, 0, 0, 2, 0, 3), ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
        (Tensor(3, 0, 0, 1, 0, 2), ((0, 0, 1), (1, 0, 0), (0, 1, 0))),
        (Tensor(1, 0, 0, 1, 0, 1), ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
        (ZERO, ((1, 0, 0), (0, 1, 0), (0, 0, 1))),
    ],
)
def test_principal_axes_of_plain_tensors_are_basis_vectors(tensor: Tensor, axes: Any) -> None:
    assert principal_axes(tensor)[1] == axes


@given(st.builds(Tensor, *[st.floats(allow_nan=True, allow_infinity=True)] * 6))
def test_principal_axes_of_anything_end(tensor: Tensor) -> None:
    assert len(principal_axes(tensor)[1]) == 3


def test_a_uniform_solid_is_the_box_it_was_made_of() -> None:
    """2 kg, 0.1 x 0.2 x 0.3 m: moments m (y^2 + z^2) / 12."""
    tensor = Tensor(0.13 / 6, 0.0, 0.0, 0.10 / 6, 0.0, 0.05 / 6)
    turned = rotated(tensor, from_rpy(0.3, -0.5, 0.7))
    assert sorted(inertia.uniform_solid(turned, 2.0)[0]) == pytest.approx([0.1, 0.2, 0.3])


def test_a_solid_of_a_tensor_that_no_body_has_is_flat() -> None:
    assert 0.0 in inertia.uniform_solid(Tensor(1.0, 0.0, 0.0, 1.0, 0.0, 5.0), 1.0)[0]
