import pytest

from tests.massive import (
    BALL,
    BOX,
    MESH,
    WHEEL,
    defects,
    inertial,
    joint,
    link,
    masses,
    part,
    shape,
)
from urdfkit.robot.inertials.defects import center_is_outside, implausible_density, unit_mistake


def ball(mass: float, moment: float, xyz: str = "0 0 0") -> str:
    """One of 1 kg with its radius of 0.1 m has 0.004 kg·m², and 0.01 at most."""
    return part("ball", mass, (moment, moment, moment), BALL, xyz)


@pytest.mark.parametrize(
    ("robot", "expected"),
    [
        (ball(1, 0.004), {}),
        (ball(1, 0.008), {}),
        (ball(1, 0.009), {"unlike shape": ["ball"]}),
        (ball(1, 0.0011), {"unlike shape": ["ball"]}),
        (ball(1, 0.0199), {"unlike shape": ["ball"]}),
        (ball(1, 0.0201), {"too large": ["ball"]}),
        (ball(1, 3.9e-5), {"too small": ["ball"]}),
        (ball(1, 4.1e-5), {"unlike shape": ["ball"]}),
        (part("ball", 1, (0.004, 0.004, 0.0082), BALL), {"triangle inequality": ["ball"]}),
        (part("ball", 1, (0.004, 0.005, 0, 0.004, 0, 0.004), BALL), {"indefinite": ["ball"]}),
        (ball(0.06, 0.00024), {"density": ["ball"]}),  # 14 kg/m³
        (ball(70, 0.28), {"density": ["ball"]}),  # 16 700 kg/m³
        (part("box", 12, (0.05, 0.1, 0.13), BOX), {"wrong axes": ["box"]}),
    ],
)
def test_each_inertia_has_one_rule(robot: str, expected: dict[str, list[str]]) -> None:
    assert defects(robot) == expected


def test_a_mesh_is_not_measured() -> None:
    seen = link("a", shape("visual", MESH), shape("collision", BALL), inertial(1, (5, 5, 5.1)))
    assert defects(seen) == {"unlike shape": ["a"]}
    computed = link(
        "a", shape("visual", MESH), shape("collision", BALL), inertial(1, (5, 5, 5.123))
    )
    assert defects(computed) == {}
    touched = link("a", shape("visual", BALL), shape("collision", MESH), inertial(1, (5, 5, 5)))
    assert defects(touched) == {}


@pytest.mark.parametrize(
    ("mass", "moment", "claimed"),
    [(1, 1.0, True), (20, 1.0, False), (0.005, 0.001, True), (0.1, 0.001, False), (1, 0.5, False)],
)
def test_a_stand_in_beside_a_mesh(mass: float, moment: float, claimed: bool) -> None:
    robot = link("a", shape("visual", MESH), inertial(mass, (moment, moment, moment)))
    assert defects(robot) == ({"placeholder": ["a"]} if claimed else {})


def test_many_equal_stand_ins_are_unlikely() -> None:
    links = [link(f"l{i}", shape("visual", MESH), inertial(2, (0.01,) * 3)) for i in range(3)]
    assert defects("".join(links[:2])) == {}
    assert defects("".join(links)) == {"placeholder": ["l0", "l1", "l2"]}


def test_a_stand_in_that_another_rule_reports_is_not_reported_twice() -> None:
    by_shape = part("wheel", 0.5, (0.1, 0.1, 0.1), WHEEL)
    by_number = link("grip", shape("visual", MESH), inertial(0.01, (0.1,) * 3))
    assert defects(by_shape + by_number) == {"too large": ["wheel"]}


def test_what_is_fixed_to_the_world_does_not_matter() -> None:
    assert defects(ball(1, 5)) == {"too large": ["ball"]}
    assert defects(link("world") + ball(1, 5) + joint("world", "ball")) == {}
    moved = link("world") + ball(1, 5) + joint("world", "ball", "continuous")
    assert defects(moved) == {"too large": ["ball"]}


def test_what_is_lost_in_a_larger_body_is_a_hint_at_most() -> None:
    base = part("base", 60, (0.5, 0.25, 0.65), BOX)
    robot = base + ball(0.001, 0.001) + joint("base", "ball")
    assert defects(robot) == {"unlike shape": ["ball"]}
    apart = base + ball(0.001, 0.001) + joint("base", "ball", "continuous")
    assert defects(apart) == {"too large": ["ball"]}


@pytest.mark.parametrize(
    ("mass", "geometry", "density"),
    [
        (6, BOX, None),
        (0.13, BOX, None),
        (0.11, BOX, None),
        (0.09, BOX, 0.09 / 0.006),
        (86, BOX, None),
        (87, BOX, 87 / 0.006),
        (1, '<box size="0.004 0.004 0.004"/>', None),
    ],
)
def test_implausible_densities(mass: float, geometry: str, density: float | None) -> None:
    (found,) = masses(part("a", mass, (1, 1, 1), geometry)).inertias
    assert implausible_density(found) == (None if density is None else pytest.approx(density))


@pytest.mark.parametrize(
    ("mass", "moments", "geometry", "unit"),
    [
        (6000, (50, 25, 65), BOX, "g"),
        (6000, (0.05, 0.025, 0.065), BOX, "g"),
        (6000, (1e-9, 1e-9, 1e-9), BOX, ""),
        (80, (1, 1, 1), BOX, ""),  # 13 kg/m³ as grams
        (1200, (10, 5, 13), BOX, "g"),  # 200 kg/m³ as grams
        (6, (0.05, 0.025, 0.065), '<box size="200 300 100"/>', "mm"),
        (42, (0.35, 0.175, 0.455), '<box size="200 300 100"/>', "mm"),  # 7000 kg/m³
        (6, (0.05, 0.025, 0.065), BOX, ""),
        (1e-6, (1e-9, 1e-9, 1e-9), '<box size="1 1 1"/>', ""),  # no part, but not so large either
        (1000, (50, 25, 65), '<box size="20 20 20"/>', ""),  # too light, and far from 1e-9 of it
    ],
)
def test_typos_of_the_unit(
    mass: float, moments: tuple[float, ...], geometry: str, unit: str
) -> None:
    (found,) = masses(part("a", mass, moments, geometry)).inertias
    assert unit_mistake(found) == unit


def test_a_typo_of_the_unit_comes_before_what_follows_from_it() -> None:
    assert defects(part("a", 6000, (0.05, 0.025, 0.065), BOX)) == {"density": ["a"]}
    small = part("a", 6, (0.05, 0.025, 0.065), '<box size="200 300 100"/>')
    assert defects(small) == {"density": ["a"]}


@pytest.mark.parametrize(
    ("xyz", "distance"),
    [("0 0 0", None), ("0.29 0 0", None), ("0.31 0 0", 0.21), ("0.25 0.35 0", 0.25)],
)
def test_centres_of_mass_outside(xyz: str, distance: float | None) -> None:
    (found,) = masses(ball(1, 0.004, xyz)).inertias
    assert center_is_outside(found) == (None if distance is None else pytest.approx(distance))
    assert ("center of mass" in defects(ball(1, 0.004, xyz))) == (distance is not None)
