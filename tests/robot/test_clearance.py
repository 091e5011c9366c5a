"""A cautious look: it may say yes for nothing, and never no where bodies meet."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.conftest import MODELS, manifest, model_id
from tests.growth import executed_lines
from tests.physics.collision.robots import box, cylinder, joint, link, mesh, revolute, robot, sphere
from tests.update_corpus_findings import arguments_of
from urdfkit.lint.context import Unavailable
from urdfkit.lint.loading import read
from urdfkit.robot.clearance import MAX_BODIES, NEAR, may_overlap

SMALL = box(0.1, 0.1, 0.1)


@pytest.mark.parametrize(
    ("first", "second", "origin", "expected"),
    [
        (SMALL, SMALL, "0.1 0 0", True),
        (SMALL, SMALL, f"{0.1 + 2 * NEAR} 0 0", False),
        (SMALL, SMALL, "0.09 0.09 0.09", True),
        (SMALL, SMALL, "5 0 0", False),
        (sphere(0.1), cylinder(0.01, 1), "0 0.1 0.4", True),
        (sphere(0.1), cylinder(0.01, 1), "0 0.2 0.4", False),
    ],
)
def test_boxes(first: str, second: str, origin: str, expected: bool) -> None:
    found = robot(link("a", first), link("b", second), joint("a", "b", origin=origin))
    assert may_overlap(found.tree) is expected


def test_bodies_of_one_link_and_meshes_and_nothing() -> None:
    assert not may_overlap(robot(link("a", SMALL, SMALL)).tree)
    assert not may_overlap(robot(link("a"), link("b"), joint("a", "b")).tree)
    parts = (link("a", SMALL), link("b", mesh(Path("/no.stl"))), joint("a", "b", origin="9 9 9"))
    assert may_overlap(robot(*parts).tree)


def test_a_joint_that_cannot_be_at_zero_is_in_the_middle() -> None:
    limits = revolute(0.2, 0.4, "1 0 0")
    parts = (link("a", SMALL), link("b", SMALL), joint("a", "b", "prismatic", more=limits))
    assert not may_overlap(robot(*parts).tree)


@pytest.mark.parametrize("entry", list(manifest()), ids=model_id)
def test_it_never_misses_what_coal_finds(entry: tuple[Path, dict[str, Any]]) -> None:
    pytest.importorskip("coal")
    folder, model = entry
    if "expect" not in model or "/fail_" in model["path"]:
        pytest.skip("it does not expand")
    subject = read(folder / model["path"], arguments=arguments_of(model))
    if not subject.is_crowded:
        assert subject.collisions.still.meetings == ()


def test_a_robot_whose_parts_keep_apart_needs_no_library() -> None:
    arm = read(MODELS / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf")
    assert not arm.is_crowded


def test_many_bodies_are_no_trouble() -> None:
    """A ladder of a thousand rungs, and a swarm that nobody could compare in time."""

    def lines(count: int) -> int:
        rungs = [link(f"l{number}", SMALL) for number in range(count)]
        joints = [joint("l0", f"l{number}", origin=f"0 0 {number}") for number in range(1, count)]
        ladder = robot(*rungs, *joints).tree
        assert not may_overlap(ladder)
        return executed_lines(lambda: may_overlap(ladder))

    assert lines(1000) < 110 * lines(10)
    swarm = robot(*(link(name, *[SMALL] * (MAX_BODIES // 2 + 1)) for name in "ab"), joint("a", "b"))
    assert may_overlap(swarm.tree)
    with pytest.raises(Unavailable, match="2002 collision bodies; more than 2000"):
        _ = swarm.collisions
