"""Contacts where a robot begins: which pairs are open, and what needs coal."""

import sys
from pathlib import Path

import pytest

from tests.conftest import ARM, CorpusRobot, manifest, model_id
from tests.physics.collision.robots import (
    box,
    cube,
    cylinder,
    joint,
    link,
    mesh,
    revolute,
    robot,
    sphere,
)
from urdfkit.errors import Unavailable
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.lint.requirements import MAX_BODIES
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.contacts import Contacts

SMALL = box(0.1, 0.1, 0.1)


def contacts(context: Context) -> Contacts:
    return context.collisions.contacts


def depths(*parts: str) -> list[float]:
    return [pair.contact.depth for pair in contacts(robot(*parts)).pairs if pair.contact]


@pytest.mark.parametrize(
    ("first", "second", "origin", "expected"),
    [
        (SMALL, SMALL, "0.1 0 0", []),
        (SMALL, SMALL, "0.09 0.09 0.09", [0.01]),
        (SMALL, SMALL, "5 0 0", []),
        (sphere(0.1), cylinder(0.01, 1), "0 0.1 0.4", [0.01]),
        (sphere(0.1), cylinder(0.01, 1), "0.1 0.1 0.4", []),
    ],
)
def test_depths(first: str, second: str, origin: str, expected: list[float]) -> None:
    parts = (link("a", first), link("b", second), joint("a", "b", origin=origin))
    assert depths(*parts) == pytest.approx(expected)


def test_bodies_of_one_link_and_meshes_that_are_not_there() -> None:
    assert depths(link("a", SMALL, SMALL)) == []
    assert depths(link("a"), link("b"), joint("a", "b")) == []
    assert depths(link("a", SMALL), link("b", mesh(Path("/no.stl"))), joint("a", "b")) == []


def test_a_joint_that_cannot_be_at_zero_is_in_the_middle() -> None:
    limits = revolute(0.2, 0.4, "1 0 0")
    apart = robot(link("a", SMALL), link("b", SMALL), joint("a", "b", "prismatic", more=limits))
    assert contacts(apart).pairs == ()
    assert "a_b 0.3: zero is beyond the limits" in contacts(apart).initial_pose


def test_followers_are_where_their_leader_takes_them() -> None:
    parts = (
        *(link(name, SMALL) for name in "abc"),
        joint("a", "b", "prismatic", "1 0 0", revolute(0.5, 1.5, "1 0 0")),
        joint("a", "c", "prismatic", "0 0 0", '<mimic joint="a_b"/>' + revolute(0, 2, "1 0 0")),
    )
    assert contacts(robot(*parts)).pairs == ()
    assert depths(*(part.replace('"1 0 0"/><axis', '"0.05 0 0"/><axis') for part in parts)) == (
        pytest.approx([0.05])
    )


def test_the_part_has_a_bound() -> None:
    parts = (link("a", SMALL), link("b", sphere(0.02)), joint("a", "b", "continuous", "0 0 0.05"))
    (pair,) = contacts(robot(*parts)).pairs
    assert pair.contact is not None
    assert pair.contact.small.link == "b"
    assert pair.contact.relative_depth == pytest.approx(0.5)
    assert pair.contact.relative_depth <= pair.max_relative_depth + 1e-12
    assert not pair.is_contained


def test_a_body_inside_another_one_and_what_is_fixed_to_it() -> None:
    parts = (
        link("a", SMALL),
        link("b", sphere(0.02)),
        link("c", sphere(0.02)),
        joint("a", "b", "continuous"),
        joint("b", "c", origin="0 0 0.01"),
    )
    inside = {pair.names: pair for pair in contacts(robot(*parts)).pairs}
    assert inside["a", "b"].is_contained
    assert inside["a", "b"].is_enclosed
    assert inside["a", "b"].is_permanent
    assert inside["b", "c"].is_rigid
    parts = (*parts[:4], joint("b", "c", origin="0 0 0.04"))
    outside = {pair.names: pair for pair in contacts(robot(*parts)).pairs}
    assert outside["a", "b"].is_contained
    assert not outside["a", "b"].is_enclosed


def test_a_pair_that_only_some_pose_separates_is_not_permanent() -> None:
    arm = (
        link("a", box(0.2, 0.2, 0.2)),
        link("b", box(0.1, 0.1, 0.6)),
        joint("a", "b", "revolute", "0 0 0.35", revolute(-1, 1, "0 1 0")),
    )
    (pair,) = contacts(robot(*arm)).pairs
    assert not pair.is_permanent
    round_about = robot(*arm[:2], joint("a", "b", "continuous", "0 0 0.35", '<axis xyz="0 0 1"/>'))
    (pair,) = contacts(round_about).pairs
    assert pair.is_permanent


def test_meshes_need_coal_where_boxes_around_them_overlap(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("coal")
    shape = mesh(cube(tmp_path / "c.stl", 0.05))
    parts = [link("a", shape), link("b", shape), joint("a", "b", "continuous", "0 0 0.09")]
    assert depths(*parts) == pytest.approx([0.01], abs=1e-6)
    monkeypatch.setitem(sys.modules, "coal", None)
    with pytest.raises(Unavailable, match="coal is not installed"):
        depths(*parts)
    assert depths(*parts[:2], joint("a", "b", "continuous", "0 0 0.11")) == []


@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_it_misses_nothing_that_coal_finds(entry: CorpusRobot) -> None:
    """Every overlap of two links where real robots begin is a contact, as deep at least."""
    pytest.importorskip("coal")
    from urdfkit.physics.collision.batch_kinematics import tree_arrays
    from urdfkit.physics.collision.collision_geometry import build_geometry
    from urdfkit.physics.collision.geometry_arrays import collision_arrays
    from urdfkit.physics.collision.pair_queries import CollisionModel

    if "expect" not in entry.facts or "/fail_" in entry.facts["path"]:
        pytest.skip("it does not expand")
    context = entry.read()
    unit = context.targets.applies_units
    moving = tree_arrays(context.tree)
    bodies, _ = collision_arrays(context.model, context.meshes, unit=unit)
    collision_model = CollisionModel(moving, map(build_geometry, bodies))
    pairs = list(moving.pairs(collision_model.links))
    seen = collision_model.query(pairs, 0.0).at(moving.default[None], count=True)
    known = {frozenset(pair.names): pair.contact for pair in contacts(context).pairs}
    for pair, one in zip(pairs, seen, strict=True):
        names = frozenset(moving.links[number] for number in pair)
        # Depths between triangles may be too large; so is that of the R2D2's head, a sphere with
        # its centre on the end of a cylinder.
        is_convex = all(
            collision_model.geometry(body).is_convex
            for link in pair
            for body in collision_model.bodies(link)
        )
        if one.distance < -2 * TOUCH and is_convex and names != {"head", "base_link"}:
            contact = known.get(names)
            assert contact is not None, names
            assert contact.depth == pytest.approx(-one.distance, abs=1e-5)


def test_a_robot_whose_parts_keep_apart_has_no_pairs() -> None:
    arm = read(ARM)
    assert contacts(arm).pairs == ()


def test_many_bodies() -> None:
    """A ladder of a thousand rungs, and a swarm that is not compared."""
    rungs = [link(f"l{number}", SMALL) for number in range(1000)]
    joints = [joint("l0", f"l{number}", origin=f"0 0 {number}") for number in range(1, 1000)]
    assert contacts(robot(*rungs, *joints)).pairs == ()
    swarm = robot(*(link(name, *[SMALL] * (MAX_BODIES // 2 + 1)) for name in "ab"), joint("a", "b"))
    with pytest.raises(Unavailable, match="2002 collision bodies; more than 2000"):
        _ = swarm.collisions
    heap = robot(
        *(link(f"l{number}", SMALL) for number in range(300)),
        *(joint("l0", f"l{number}", origin="0 0 0") for number in range(1, 300)),
    )
    with pytest.raises(Unavailable, match="more than 20000 pairs of collision bodies may overlap"):
        _ = contacts(heap).pairs
