"""What the shortcuts leave out is what measuring everything would not have found."""

from itertools import combinations, pairwise
from math import inf
from pathlib import Path
from typing import Any

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

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
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision.batch_kinematics import TreeArrays, tree_arrays
from urdfkit.physics.collision.bodies import TOUCH
from urdfkit.physics.collision.collision_geometry import DistanceQuery, build_geometry
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.pair_queries import SLACK, CollisionModel, Pair


def collision_model(context: Context) -> CollisionModel:
    bodies, _ = collision_arrays(context.model, context.meshes)
    return CollisionModel(tree_arrays(context.tree), map(build_geometry, bodies))


def everything(one: CollisionModel, pair: Pair, rows: Floats) -> Floats:
    """(n,): the signed distance of two links, each of their bodies measured in each sample."""
    frames = one.frames(rows, pair)
    found = np.full(len(rows), inf)
    for first, second, query in one.queries(pair):
        for sample in range(len(rows)):
            way = np.linalg.inv(frames[first][sample]) @ frames[second][sample]
            distance = query.distance(way[:3, :3], way[:3, 3], inf)
            found[sample] = min(found[sample], distance)
    return found


def arm(directory: Path) -> Context:
    """Six links with all sorts of bodies, some of them surfaces, that often collide."""
    shell = mesh(cube(directory / "shell.stl", 0.06, 5))
    solid = mesh(cube(directory / "solid.stl", 0.05))
    turn = revolute(-2.5, 2.5, "0 1 0")
    return robot(
        link("base", box(0.3, 0.3, 0.1)),
        link("a", cylinder(0.05, 0.3) + "@0 0 0.15", sphere(0.07)),
        link("b", shell + "@0 0 0.1", solid + "@0 0 0.2"),
        link("c", sphere(0.05), shell + "@0 0 0.1"),
        link("d", solid + "@0 0 0.1"),
        joint("base", "a", "continuous", "0 0 0.06", '<axis xyz="0 0 1"/>'),
        joint("a", "b", "revolute", "0 0 0.3", turn),
        joint("b", "c", "revolute", "0 0 0.25", turn),
        joint("c", "d", "prismatic", "0 0 0.1", revolute(-0.1, 0.1)),
    )


def agree(one: CollisionModel, rows: Floats) -> int:
    """Compare the shortcuts with measuring everything; how many collisions there are."""
    pairs = list(combinations(one.links, 2))
    counted = one.query(pairs).at(rows, count=True)
    searched = one.query(pairs).at(rows, count=False)
    total = 0
    for pair, seen, quick in zip(pairs, counted, searched, strict=True):
        true = everything(one, pair, rows)
        hits = np.flatnonzero(true < -TOUCH).tolist()
        total += len(hits)
        assert seen.hits == hits
        assert len(quick.hits) == (len(hits) > 0)
        assert seen.row >= 0
        assert seen.distance == pytest.approx(true[seen.row], abs=1e-6)
        if hits:
            assert seen.distance < 0
        else:
            assert true.min() >= (1 - SLACK) * seen.distance - 1e-6
    return total


def test_a_robot_of_all_sorts_of_bodies(tmp_path: Path) -> None:
    one = collision_model(arm(tmp_path))
    assert agree(one, one.kinematics.samples(200, 0, 0)) > 100


@pytest.mark.parametrize(
    "path",
    [
        "moveit_resources/panda_description/urdf/panda.urdf",
        "moveit_resources/fanuc_description/urdf/fanuc.urdf",
    ],
)
def test_real_arms(corpus: Path, path: str) -> None:
    one = collision_model(read(corpus / path))
    assert agree(one, one.kinematics.samples(25, 1, 0)) > 0


def test_a_look_goes_on_from_block_to_block(tmp_path: Path) -> None:
    one = collision_model(arm(tmp_path))
    pairs = [(0, 3)]
    rows = one.kinematics.samples(300, 0, 0)
    look = one.query([(0, 3), (0, 4)])
    blocks = (0, 100, 200)
    seen = [look.at(rows[start : start + 100], pairs, count=True)[0] for start in blocks]
    (whole,) = one.query(pairs).at(rows, count=True)
    found = [start + hit for start, part in zip(blocks, seen, strict=True) for hit in part.hits]
    assert found == whole.hits
    assert min(part.distance for part in seen) == seen[-1].distance


def test_what_is_beyond_the_limit_is_passed_over(tmp_path: Path) -> None:
    one = collision_model(
        robot(link("a", sphere(0.1)), link("b", sphere(0.1)), joint("a", "b", origin="1 0 0"))
    )
    rows = one.kinematics.default[None]
    (seen,) = one.query([(0, 1)]).at(rows, count=True)
    assert (seen.hits, seen.row) == ([], 0)
    assert seen.distance == pytest.approx(0.8)
    (seen,) = one.query([(0, 1)], 0.5).at(rows, count=True)
    assert (seen.hits, seen.distance, seen.row) == ([], 0.5, -1)


def test_memory_is_that_of_a_block() -> None:
    """The frames of a thousand samples of a hundred links."""
    names = [f"l{number}" for number in range(100)]
    joints = [joint(a, b, "continuous", "0 0 1") for a, b in pairwise(names)]
    arrays: TreeArrays = tree_arrays(robot(*map(link, names), *joints).tree)
    frames = arrays.frames(arrays.samples(1000, 0, 0), range(100))
    assert sum(frame.nbytes for frame in frames.values()) < 15e6


@pytest.mark.parametrize(("effort", "measured"), [(100, 11), (inf, 200)])
def test_bodies_that_are_always_near_are_given_up(
    effort: float, measured: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Gears that mesh took minutes: they never collide, and bounds do not separate them."""
    shell = mesh(cube(tmp_path / "shell.stl", 0.06, 5))
    ball = sphere(0.001) + "@0 0.02 0"
    one = collision_model(
        robot(link("a", shell), link("b", ball), joint("a", "b", "continuous"), directory=tmp_path)
    )
    (pair,) = combinations(one.links, 2)
    rows = one.kinematics.samples(200, 0, 0)[:200]
    distance, calls = DistanceQuery.distance, []

    def counted(self: DistanceQuery, *arguments: Any) -> float:
        calls.append(0)
        return distance(self, *arguments)

    monkeypatch.setattr(DistanceQuery, "distance", counted)
    (found,) = one.query([pair], 0.0, effort=effort).at(rows, count=True)
    assert (found.hits, len(calls)) == ([], measured)
