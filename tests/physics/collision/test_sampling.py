"""The matrix: what it must be where that is known, and that nothing but the seed matters."""

import os
from math import acos, asin, pi, sqrt
from pathlib import Path
from typing import Any

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

from tests.conftest import GRIPPER
from tests.physics.collision.robots import box, joint, link, revolute, robot, sphere
from urdfkit.core import child_process
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.mesh.geometry import Floats
from urdfkit.physics.collision import worker_pool
from urdfkit.physics.collision.batch_kinematics import tree_arrays
from urdfkit.physics.collision.geometry_arrays import collision_arrays
from urdfkit.physics.collision.matrix import Matrix, PairVerdict
from urdfkit.physics.collision.pair_queries import CollisionModel
from urdfkit.physics.collision.sampling import collisions
from urdfkit.physics.collision.task import COUNTED_SAMPLES, PairFindings, Task
from urdfkit.physics.collision.worker_pool import CollisionError, WorkerPool


def verdicts(matrix: Matrix) -> dict[tuple[str, str], str]:
    return {(pair.first, pair.second): pair.verdict.value for pair in matrix.pairs}


def spheres(radius: float, *arms: float, limits: str = revolute(-pi, pi)) -> Context:
    """A base at the origin; an elbow joint; balls in the base, at the elbow and at the tip."""
    upper, lower = arms
    return robot(
        link("base", sphere(radius)),
        link("upper", sphere(0.01) + f"@{upper} 0 0"),
        link("lower", sphere(radius) + f"@{lower} 0 0"),
        joint("base", "upper", "continuous", more='<axis xyz="0 0 1"/>'),
        joint("upper", "lower", "revolute", f"{upper} 0 0", limits),
    )


def test_how_often_a_two_link_arm_hits_itself_is_what_geometry_says() -> None:
    """The balls of base and tip touch where the law of cosines makes their centres 2 r apart."""
    upper, lower, radius = 1.0, 0.9, 0.2
    cosine = (upper**2 + lower**2 - (2 * radius) ** 2) / (2 * upper * lower)
    expected = 2 * acos(cosine) / (2 * pi)  # of the range of the elbow
    found = {
        (p.first, p.second): p for p in collisions(spheres(radius, upper, lower), jobs=1).pairs
    }
    pair = found["base", "lower"]
    assert pair.verdict is PairVerdict.SOMETIMES
    deviation = sqrt(expected * (1 - expected) / COUNTED_SAMPLES)
    assert pair.frequency == pytest.approx(expected, abs=4 * deviation)
    assert pair.nearest is not None
    assert pair.nearest.distance == pytest.approx(upper - lower - 2 * radius, abs=0.01)
    assert set(pair.nearest.pose) == {"base_upper", "upper_lower"}
    assert abs(pair.nearest.pose["upper_lower"]) == pytest.approx(pi, abs=0.2)
    assert found["base", "upper"].verdict is PairVerdict.ADJACENT


def test_a_collision_that_no_sample_shows_is_found_from_the_near_ones() -> None:
    """The balls overlap in 1/40 000 of the range of the elbow."""
    upper, radius = 1.0, 0.2
    limit = pi - 2 * asin((2 * radius) / (2 * upper)) + 8e-5
    arm = spheres(radius, upper, upper, limits=revolute(-2.0, limit))
    for seed in range(3):
        assert verdicts(collisions(arm, seed=seed, jobs=1))["base", "lower"] == "sometimes"
    short = spheres(radius, upper, upper, limits=revolute(-2.0, limit - 1.6e-4))
    found = collisions(short, jobs=1)
    assert verdicts(found)["base", "lower"] == "never"
    (near,) = found.near_misses
    assert near.nearest is not None
    assert near.nearest.distance == pytest.approx(8e-5 * sqrt(1 - 0.2**2), rel=0.3)
    assert near.nearest.pose["upper_lower"] == pytest.approx(limit - 1.6e-4, abs=1e-4)


def test_every_verdict() -> None:
    turn = revolute(-3, 3)
    found = collisions(
        robot(
            link("base", box(1, 1, 1)),
            link("arm", sphere(0.1) + "@0 0 1"),
            link("inside", sphere(0.2)),
            link("beginning", sphere(0.1) + "@0.55 0 0"),
            link("far", sphere(0.1)),
            joint("base", "arm", "revolute", more=turn),
            joint("arm", "inside", "continuous"),
            joint("arm", "beginning", "revolute", more=revolute(-1, 1, "0 1 0")),
            joint("arm", "far", origin="0 0 5"),
        ),
        jobs=1,
    )
    assert {pair: v for pair, v in verdicts(found).items() if "base" in pair} == {
        ("base", "arm"): "adjacent",
        ("base", "inside"): "default",
        ("base", "beginning"): "default",
        ("base", "far"): "never",
    }
    always = {(p.first, p.second): p.frequency for p in found.pairs}
    assert always["base", "inside"] == 1
    begun = collisions(robot(*_rising()), jobs=1)
    assert verdicts(begun)["base", "top"] == "always"


def test_what_no_joint_binds_is_not_compared() -> None:
    """Two roots, what floats, and a loop: all balls would be in one another at their origins."""
    ball = sphere(0.1)
    found = collisions(
        robot(
            *(link(name, ball) for name in ("a", "b", "c", "d", "e", "f", "g")),
            joint("b", "c", "continuous"),
            joint("c", "d", "planar"),
            joint("d", "e", "continuous", "1 0 0"),
            joint("f", "g"),
            joint("g", "f"),
        ),
        samples=10,
        jobs=1,
    )
    assert verdicts(found) == {("b", "c"): "adjacent", ("d", "e"): "adjacent"}
    assert found.parts == ("a", "b", "d", "f", "g")
    assert collisions(robot(link("a", ball), link("b"), joint("a", "b")), jobs=1).parts == ()


def test_the_parts_of_a_robot_are_reported() -> None:
    from urdfkit.cli.collisions import shown

    found = collisions(robot(link("a", sphere(1)), link("b", sphere(1))), samples=0, jobs=1)
    assert "2 parts, with roots a, b: links of different parts are not compared" in shown.text(
        found, None
    )
    assert shown.as_json(found, None)["parts"] == ["a", "b"]


def _rising() -> tuple[str, ...]:
    """The top leaves the base in a fiftieth of its way, where it begins."""
    return (
        link("base", box(1, 1, 1)),
        link("mid", sphere(0.1) + "@0 0 -2"),
        link("top", sphere(0.1)),
        joint("base", "mid", "prismatic", "0 0 0.611", revolute(-0.5, 0, "0 0 1")),
        joint("mid", "top"),
    )


def test_where_the_robot_begins_decides_what_is_default() -> None:
    parts = _rising()
    assert verdicts(collisions(robot(*parts), jobs=1, begin={"base_mid": -0.3})) == {
        ("base", "mid"): "adjacent",
        ("base", "top"): "default",
        ("mid", "top"): "adjacent",
    }


def test_touching_is_no_collision() -> None:
    found = collisions(
        robot(
            *(link(name, box(1, 1, 1)) for name in "abc"),
            joint("a", "b", origin="3 0 0"),
            joint("b", "c", "prismatic", "-2 0 0", revolute(0, 1, "0 1 0")),
        ),
        jobs=1,
    )
    assert verdicts(found)["a", "c"] == "never"


def test_the_number_of_processes_changes_nothing_and_the_seed_does(corpus: Path) -> None:
    arm = read(corpus / "moveit_resources/fanuc_description/urdf/fanuc.urdf")
    one, two = (collisions(arm, samples=1500, jobs=jobs) for jobs in (1, 3))
    assert one == two
    other = collisions(arm, samples=1500, seed=1, jobs=1)
    assert [p.frequency for p in other.pairs] != [p.frequency for p in one.pairs]


ARMS = {
    "panda": ("moveit_resources/panda_description/urdf/panda.urdf", {}),
    "ur5e": (
        "Universal_Robots_ROS2_Description/urdf/ur.urdf.xacro",
        {"ur_type": "ur5e", "name": "ur"},
    ),
}


@pytest.mark.parametrize("name", ARMS)
def test_two_seeds_give_the_same_matrix(corpus: Path, name: str) -> None:
    path, arguments = ARMS[name]
    arm = read(corpus / path, arguments=arguments)
    first, second = (verdicts(collisions(arm, seed=seed)) for seed in range(2))
    assert first == second


def test_progress_is_reported_from_nothing_to_all() -> None:
    reported: list[tuple[int, int]] = []
    arm = spheres(0.1, 1.0, 0.5)
    collisions(
        arm, samples=3000, jobs=1, progress=lambda done, total: reported.append((done, total))
    )
    assert [done for done, _ in reported] == sorted(done for done, _ in reported)
    assert reported[-1] == (3000, 3000)


def test_more_samples_are_given_up_when_they_show_nothing_new() -> None:
    found = collisions(spheres(0.1, 1.0, 0.5), samples=10**7, jobs=1)
    assert (found.samples, found.asked) == (16_000, 10**7)


def test_no_samples_show_where_the_robot_begins() -> None:
    found = collisions(spheres(0.1, 1.0, 0.5), samples=0, jobs=1)
    assert verdicts(found)["base", "lower"] == "never"
    assert [pair.frequency for pair in found.pairs] == [None] * 3


@pytest.mark.parametrize(
    "parts",
    [
        (),
        (link("a"),),
        (link("a", sphere(1)),),
        (link("a", sphere(1)), link("b", sphere(1)), joint("a", "b"), joint("b", "a")),
        (link("a", sphere(1)), link("b", sphere(1))),
        (link("a", ""), link("b", box(1e300, 1, 1))),
    ],
)
def test_robots_without_much_to_measure(parts: tuple[str, ...]) -> None:
    found = collisions(robot(*parts), samples=10, jobs=1)
    assert len(found.pairs) <= 1


def test_too_many_pairs_are_refused_at_once() -> None:
    links = [link(f"l{number}", sphere(0.1)) for number in range(400)]
    joints = [joint("l0", f"l{number}") for number in range(1, 400)]
    with pytest.raises(CollisionError, match="400 links with collision geometry are too many"):
        collisions(robot(*links, *joints), jobs=1)


class Crash(Task):
    """A task that ends the process for one pair."""

    def run(self, collision_model: CollisionModel) -> list[PairFindings]:
        if (0, 2) in self.pairs:
            os.abort()
        return super().run(collision_model)


PAIRS = ((0, 1), (0, 2), (1, 2))


def pool_of(context: Context) -> tuple[WorkerPool, Floats]:
    moving = tree_arrays(context.tree)
    return WorkerPool(moving, collision_arrays(context.model, context.meshes)[0], 2), moving.default


def test_a_crash_costs_one_pair() -> None:
    pool, start = pool_of(spheres(0.1, 1.0, 0.5))
    moves = (True,) * 3
    with pool:
        ((first, second, third),) = pool.run([Crash(PAIRS, moves, start, 10, 0)], lambda: None)
        assert second is None
        assert first is not None
        assert third is not None
        (again,) = pool.run([Task(PAIRS, moves, start, 10, 0)], lambda: None)  # the pool goes on
        assert None not in again


def test_a_robot_that_crashes_all_the_time_is_given_up(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker_pool, "_MAX_CRASHES", 2)
    pool, start = pool_of(spheres(0.1, 1.0, 0.5))
    with pool, pytest.raises(CollisionError, match="coal crashed"):
        pool.run([Crash(PAIRS[1:2], (True,), start, 10, 0)] * 5, lambda: None)


def test_a_body_that_is_fatal_is_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    """The second of three bodies ends every process that makes it."""
    boot = child_process._BOOT.replace(
        "__import__",
        "from urdfkit.physics.collision import collision_geometry as geometries; "
        "import os; make = geometries.build_geometry; "
        "geometries.build_geometry = lambda s: os.abort() if s.link == 'upper' else make(s); "
        "__import__",
    )
    monkeypatch.setattr(child_process, "_BOOT", boot)
    found = collisions(spheres(0.1, 1.0, 0.5), samples=100, jobs=2)
    assert [(one.link, one.reason) for one in found.omitted] == [("upper", "it crashes coal")]
    assert list(verdicts(found)) == [("base", "lower")]


def test_an_interrupt_ends_all_processes() -> None:
    started: list[Any] = []
    original = worker_pool._Worker.__init__

    def noted(self: Any, *args: Any) -> None:
        original(self, *args)
        started.append(self)

    def interrupt(done: int, total: int) -> None:
        raise KeyboardInterrupt

    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(worker_pool._Worker, "__init__", noted)
        with pytest.raises(KeyboardInterrupt):
            collisions(spheres(0.1, 1.0, 0.5), jobs=2, progress=interrupt)
    assert started
    assert all(worker._process.poll() is not None for worker in started)


def test_modules_are_not_imported_from_where_we_stand(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A directory with robots may hold anything."""
    (tmp_path / "numpy.py").write_text("raise SystemExit('imported')")
    (tmp_path / "pickle.py").write_text("raise SystemExit('imported')")
    monkeypatch.chdir(tmp_path)
    found = collisions(read(GRIPPER), samples=10, jobs=1)
    assert len(found.pairs) == 3
