"""What descents find, against closed forms, and against many samples."""

from itertools import combinations
from math import asin, cos, hypot, pi
from pathlib import Path

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

from tests.physics.collision.robots import box, joint, link, revolute, robot, sphere
from tests.physics.collision.test_pair_queries import arm, collision_model, everything
from urdfkit.lint.loading import read
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.local_minimisation import ClosestPair, closest
from urdfkit.physics.collision.pair_queries import CollisionModel


def of(one: CollisionModel, first: str, second: str) -> ClosestPair:
    names = one.kinematics.links
    a, b = sorted((names.index(first), names.index(second)))
    return closest(one, (a, b))


def test_two_balls_on_an_elbow_come_as_near_as_the_limit_lets_them() -> None:
    """At an angle q of the elbow their centres are |u + l e^iq| apart."""
    upper, lower, radius, limit = 1.0, 0.8, 0.05, 2.5
    one = collision_model(
        robot(
            link("base", sphere(radius)),
            link("upper"),
            link("tip", sphere(radius) + f"@{lower} 0 0"),
            joint("base", "upper", "continuous", more='<axis xyz="0 0 1"/>'),
            joint("upper", "tip", "revolute", f"{upper} 0 0", revolute(-1, limit)),
        )
    )
    found = of(one, "base", "tip")
    centres = hypot(upper + lower * cos(limit), lower * np.sin(limit))
    assert found.distance == pytest.approx(centres - 2 * radius, abs=1e-6)
    assert found.configuration[1] == pytest.approx(limit, abs=1e-6)


def test_a_slide_and_a_follower() -> None:
    """The follower goes twice as far, towards the wall at 1 m."""
    leader = joint("base", "a", "prismatic", more=revolute(-0.1, 0.3, "1 0 0"))
    law = '<mimic joint="base_a" multiplier="2" offset="0.05"/>'
    one = collision_model(
        robot(
            link("base", box(0.2, 1, 1) + "@1.1 0 0"),
            link("a"),
            link("b", sphere(0.02)),
            leader,
            joint("base", "b", "prismatic", more=revolute(-9, 9, "1 0 0") + law),
        )
    )
    found = of(one, "base", "b")
    assert found.distance == pytest.approx(1 - 2 * 0.3 - 0.05 - 0.02, abs=1e-6)
    assert found.configuration.tolist() == pytest.approx([0.3], abs=1e-6)


@pytest.mark.parametrize("depth", [1e-3, 1e-4, 2e-5])
def test_a_collision_of_a_hair(depth: float) -> None:
    """Balls at the ends of two equal arms, of which the limit lets them overlap so deep."""
    radius = 0.2
    limit = pi - 2 * asin((2 * radius - depth) / 2)
    one = collision_model(
        robot(
            link("base", sphere(radius)),
            link("upper"),
            link("tip", sphere(radius) + "@1 0 0"),
            joint("base", "upper", "continuous", more='<axis xyz="0 0 1"/>'),
            joint("upper", "tip", "revolute", "1 0 0", revolute(-2, limit)),
        )
    )
    found = of(one, "base", "tip")
    assert -depth * 1.001 < found.distance < -TOUCH
    assert everything(one, (0, 2), found.configuration[None])[0] == pytest.approx(found.distance)


def test_no_sample_is_nearer(tmp_path: Path) -> None:
    """Of a robot with meshes that are no convex bodies."""
    one = collision_model(arm(tmp_path))
    rows = one.kinematics.samples(300, 0, 0)
    for pair in combinations(one.links, 2):
        found = closest(one, pair)
        true = everything(one, pair, rows).min()
        at = everything(one, pair, found.configuration[None])[0]
        if found.distance < -TOUCH:
            assert at <= found.distance + 1e-9  # another body may overlap more
        else:
            assert at == pytest.approx(found.distance, abs=1e-9)
            assert found.distance <= true + 1e-4


def test_what_ten_thousand_samples_show_with_some_seeds_only(corpus: Path) -> None:
    """Feet and shanks of a quadruped, which touch in some of 10 000 poses."""
    one = collision_model(read(corpus / "anymal_c_simple_description/urdf/anymal.urdf"))
    for first, second in (
        ("LF_shank_fixed", "RF_shank_fixed"),
        ("LF_FOOT", "RF_KFE"),
        ("LH_KFE", "RH_FOOT"),
        ("LF_thigh_fixed", "RF_thigh_fixed"),
    ):
        assert of(one, first, second).distance < -TOUCH, (first, second)
    assert of(one, "base", "LF_FOOT").distance > 0.05
