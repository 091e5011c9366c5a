from math import pi, sqrt

import pytest

from tests.massive import BALL, BOX, MESH, WHEEL, inertial, link, link_inertia, part, shape
from urdfkit.robot.inertials.link_comparison import NOISE

#: Of 0.5 kg with a radius of 0.06 m and a length of 0.05 m.
ACROSS, ALONG = 0.5 * (3 * 0.06**2 + 0.05**2) / 12, 0.5 * 0.06**2 / 2

TURNED = f"{pi / 2!r} 0 0"


def test_the_bound_is_all_mass_at_the_farthest_point() -> None:
    found = link_inertia(part("wheel", 0.5, (0.1, 0.1, 0.1), WHEEL))
    assert found.reach == pytest.approx(sqrt(0.06**2 + 0.025**2))
    assert found.largest_possible == pytest.approx(0.5 * (0.06**2 + 0.025**2))
    assert found.radius_of_gyration == pytest.approx(sqrt(0.1 / 0.5))
    off = link_inertia(part("ball", 2, (1, 1, 1), BALL, xyz="0.3 0 0"))
    assert off.largest_possible == pytest.approx(2 * 0.4**2)


def test_the_farther_of_collision_and_visual_counts() -> None:
    both = link("a", shape("collision", BALL), shape("visual", BOX), inertial(1, (1, 1, 1)))
    assert link_inertia(both).reach == pytest.approx(sqrt(0.01 + 0.0225 + 0.0025))
    assert link_inertia(both).bounds.edges == pytest.approx((0.2, 0.3, 0.2))


def test_the_expected_tensor_is_along_the_axes_of_the_inertial() -> None:
    wheel = shape("collision", WHEEL, rpy=TURNED)
    lying = link_inertia(link("a", wheel, inertial(0.5, (1, 1, 1))))
    assert lying.expected == pytest.approx((ACROSS, 0, 0, ALONG, 0, ACROSS), abs=1e-12)
    with_it = link_inertia(link("a", wheel, inertial(0.5, (1, 1, 1), rpy=TURNED)))
    assert with_it.expected == pytest.approx((ACROSS, 0, 0, ACROSS, 0, ALONG), abs=1e-12)


def test_collisions_come_before_visuals() -> None:
    both = link("a", shape("visual", BALL), shape("collision", BOX), inertial(12, (1, 1, 1)))
    assert str(link_inertia(both).solid) == "box of 0.2 x 0.3 x 0.1 m"
    seen = link("a", shape("visual", BALL), inertial(12, (1, 1, 1)))
    assert str(link_inertia(seen).solid) == "sphere of radius 0.1 m"


@pytest.mark.parametrize(
    ("shapes", "measured", "solid"),
    [
        ("", False, False),
        (shape("collision", BOX), True, True),
        (shape("visual", BOX), True, True),
        (shape("visual", BOX) + shape("collision", BALL), True, True),
        (shape("visual", MESH) + shape("collision", BALL), False, True),
        (shape("visual", BALL) + shape("collision", MESH), False, False),
        (shape("collision", BALL) + shape("collision", MESH), False, False),
        (shape("visual", MESH), False, False),
    ],
)
def test_what_is_measured(shapes: str, measured: bool, solid: bool) -> None:
    found = link_inertia(link("a", shapes, inertial(1, (1, 1, 1))))
    assert (found.is_measured, found.solid is not None) == (measured, solid)
    assert (found.expected is not None) == solid


@pytest.mark.parametrize(
    ("moments", "indefinite", "breaks"),
    [
        ((1, 1, 2), False, False),
        ((1, 1, 2.019), False, False),
        ((1, 1, 2.021), False, True),
        ((0, 1, 1), False, False),
        ((0, 0, 1), False, True),
        ((-0.009, 1, 1), False, False),
        ((-0.02, 1, 1), True, True),
        ((0.001, 0.1, 0, 0.001, 0, 0.1), True, True),
        ((0, 0, 0), False, False),
        ((-1e-14, 1e-14, 1e-13), False, False),  # noise
        ((1, 1, 1, 1, 1, 1), False, True),
    ],
)
def test_what_is_impossible(moments: tuple[float, ...], indefinite: bool, breaks: bool) -> None:
    found = link_inertia(part("a", 1, moments, BOX))
    assert (found.is_indefinite, found.breaks_triangle) == (indefinite, breaks)


def test_a_ball_of_a_milligram_is_no_noise() -> None:
    assert not link_inertia(part("a", 1e-6, (4e-13, 4e-13, 4e-13), BALL)).is_negligible
    assert link_inertia(part("a", 1e-6, (NOISE, NOISE, NOISE), BALL)).is_negligible


@pytest.mark.parametrize(
    ("moments", "diagonal", "rounded", "placeholder"),
    [
        ((0.1, 0.1, 0.1), True, True, True),
        ((1e-3, 1e-3, 1e-3), True, True, True),
        ((1e-4, 1e-4, 1e-4), True, True, False),
        ((0.2, 0.2, 0.2), True, True, False),
        ((0.1, 0.1, 0.2), True, True, False),
        ((0.12, 0.0012, 12), True, True, False),
        ((0.123, 0.1, 0.1), True, False, False),
        ((0.1, 0.1, 0, 0.1, 0, 0.1), False, True, False),
    ],
)
def test_what_people_write(
    moments: tuple[float, ...], diagonal: bool, rounded: bool, placeholder: bool
) -> None:
    found = link_inertia(part("a", 1, moments, BOX))
    assert (found.is_diagonal, found.has_round_numbers, found.is_placeholder) == (
        diagonal,
        rounded,
        placeholder,
    )


@pytest.mark.parametrize(
    ("factors", "differs"),
    [
        ((1, 1, 1), False),
        ((0.31, 1, 1), False),
        ((0.29, 1, 1), True),
        ((3.4, 3.4, 3.4), False),  # many digits: computed from something
        ((3.6, 3.4, 3.4), True),
    ],
)
def test_what_differs_from_the_solid(factors: tuple[float, ...], differs: bool) -> None:
    moments = tuple(a * b for a, b in zip(factors, (ACROSS, ACROSS, ALONG), strict=True))
    assert link_inertia(part("a", 0.5, moments, WHEEL)).differs is differs


def test_a_round_tensor_may_be_that_of_a_shell_at_most() -> None:
    # A ball of 2.5 kg and 0.1 m has 0.01; a shell of it 0.0167.
    assert not link_inertia(part("a", 2.5, (0.02, 0.02, 0.02), BALL)).differs
    assert link_inertia(part("a", 2.5, (0.021, 0.021, 0.021), BALL)).differs
    assert not link_inertia(part("a", 2.5, (0.021, 0.001, 0, 0.021, 0, 0.021), BALL)).differs


def test_moments_at_the_wrong_axes() -> None:
    right, wrong = (ACROSS, ACROSS, ALONG), (ALONG, ACROSS, ACROSS)
    assert not link_inertia(part("a", 0.5, right, WHEEL)).is_at_wrong_axes
    assert link_inertia(part("a", 0.5, wrong, WHEEL)).is_at_wrong_axes
    assert not link_inertia(part("a", 0.5, (ALONG * 1.1, ACROSS, ACROSS), WHEEL)).is_at_wrong_axes
    nearly_cubic = part("a", 12, (1.0, 1.05, 1.1), '<box size="0.71 0.72 0.73"/>')
    assert not link_inertia(nearly_cubic).is_at_wrong_axes


@pytest.mark.parametrize(
    ("shapes", "densities"),
    [
        (shape("collision", BOX), (1000, 1000)),
        (shape("collision", BOX) + shape("visual", '<box size="0.2 0.3 0.2"/>'), (500, 1000)),
        (shape("visual", BOX), None),
        (shape("collision", BOX) + shape("visual", MESH), None),
        (shape("collision", '<box size="0.005 0.005 0.005"/>'), None),
    ],
)
def test_densities(shapes: str, densities: tuple[float, float] | None) -> None:
    found = link_inertia(link("a", shapes, inertial(6, (1, 1, 1)))).densities
    assert found == (None if densities is None else pytest.approx(densities))


def test_twice_the_size() -> None:
    twice = link_inertia(part("a", 0.5, (1, 1, 1), WHEEL)).expected_of_twice
    assert twice is not None
    assert twice.izz == pytest.approx(4 * ALONG)
    assert twice.ixx == pytest.approx(0.5 * (3 * 0.12**2 + 0.05**2) / 12)
    both = link("a", shape("collision", BALL) * 2, inertial(1, (1, 1, 1)))
    assert link_inertia(both).expected_of_twice is None
