"""Frames of many configurations, against the ones of `kinematics` and against Pinocchio."""

from math import pi
from typing import Any

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("coal")

import itertools

from tests.conftest import ARM, manifest, model_id, needs_corpus
from tests.physics.collision.robots import joint, link, revolute, robot
from urdfkit.lint.context import Context
from urdfkit.lint.loading import read
from urdfkit.mesh.transforms import homogeneous
from urdfkit.physics.collision.batch_kinematics import slopes, tree_arrays
from urdfkit.robot import kinematics
from urdfkit.robot.joint_limits import MAX_TRAVEL

MIMIC = '<mimic joint="a_b" multiplier="-2" offset="0.1"/>'
ENTRIES = [
    entry
    for entry in manifest()
    if entry.facts.get("expect", {}).get("dof") and "/fail_" not in entry.facts["path"]
]


def agrees(context: Context) -> None:
    """The frames of a few samples are those that `kinematics` computes one by one."""
    arrays = tree_arrays(context.tree)
    rows = arrays.samples(3, 7, 0)
    frames = arrays.frames(rows, range(len(arrays.links)))
    for sample, row in enumerate(rows):
        given = {axis.joint: float(value) for axis, value in zip(arrays.axes, row, strict=True)}
        expected = kinematics.frames(context.tree, given)
        for number, name in enumerate(arrays.links):
            if name in expected:
                known = homogeneous(*expected[name])
                assert frames[number][sample] == pytest.approx(known, abs=1e-12), name


def test_every_kind_of_joint_with_mimic() -> None:
    agrees(
        robot(
            *(link(name) for name in "abcdefg"),
            joint("a", "b", "revolute", "1 2 3", revolute(-1, 2, "1 1 0")),
            joint("b", "c", "prismatic", "0 0 1", revolute(0, 0.3, "0 2 0")),
            joint("b", "d", "continuous", "0 1 0", '<axis xyz="0 0 1"/>'),
            joint("d", "e", "revolute", "0 1 1", revolute(-1, 1) + MIMIC),
            joint("e", "f", "floating", "1 0 0"),
            joint("f", "g", "fixed", "1 0 0"),
        )
    )


@needs_corpus
@pytest.mark.parametrize("entry", ENTRIES, ids=model_id)
def test_robots_of_the_corpus(entry: Any) -> None:
    agrees(entry.read())


def test_against_pinocchio() -> None:
    pin: Any = pytest.importorskip("pinocchio")
    arrays = tree_arrays(read(ARM).tree)
    model = pin.buildModelFromUrdf(str(ARM))
    data = model.createData()
    rows = arrays.samples(5, 0, 0)
    frames = arrays.frames(rows, range(len(arrays.links)))
    assert [axis.joint for axis in arrays.axes] == list(model.names)[1:]
    for sample, row in enumerate(rows):
        pin.framesForwardKinematics(model, data, row)
        for number, name in enumerate(arrays.links):
            known = data.oMf[model.getBodyId(name)].homogeneous
            assert frames[number][sample] == pytest.approx(known, abs=1e-12)


def ranges(kind: str, more: str) -> tuple[float, float]:
    arrays = tree_arrays(robot(link("a"), link("b"), joint("a", "b", kind, more=more)).tree)
    (axis,) = arrays.axes
    return axis.lower, axis.upper


def test_limits_are_kept_and_joints_without_turn_once_around() -> None:
    assert ranges("revolute", revolute(-1, 2)) == (-1, 2)
    assert ranges("prismatic", revolute(0, 0.04)) == (0, 0.04)
    assert ranges("continuous", revolute(-1, 2)) == (-pi, pi)
    assert ranges("revolute", revolute(-1e16, 1e16)) == (-pi, pi)
    assert ranges("revolute", revolute(1, -1)) == (-pi, pi)  # "free", to Bullet
    assert ranges("revolute", "") == (-pi, pi)
    assert ranges("prismatic", revolute(-1e9, 1e9)) == (-MAX_TRAVEL, MAX_TRAVEL)
    assert ranges("prismatic", revolute(1, -1)) == (0, 0)


def test_samples_fill_the_range_evenly_and_depend_on_seed_and_block() -> None:
    parts = (link("a"), link("b"), joint("a", "b", "revolute", more=revolute(-1, 3)))
    arrays = tree_arrays(robot(*parts).tree)
    rows = arrays.samples(4000, 0, 0)
    assert rows.min() >= -1
    assert rows.max() <= 3
    counts, _ = np.histogram(rows, 4, (-1, 3))
    assert counts == pytest.approx([1000] * 4, rel=0.1)
    assert (rows == arrays.samples(4000, 0, 0)).all()
    assert (rows[:10] == arrays.samples(10, 0, 0)).all()
    assert (rows != arrays.samples(4000, 0, 1)).any()
    assert (rows != arrays.samples(4000, 1, 0)).any()


def test_the_default_is_zero_or_the_middle() -> None:
    arrays = tree_arrays(
        robot(
            *(link(name) for name in "abc"),
            joint("a", "b", "revolute", more=revolute(-1, 2)),
            joint("b", "c", "revolute", more=revolute(1, 2)),
        ).tree
    )
    assert arrays.default.tolist() == [0, 1.5]


def test_the_axes_between_two_links() -> None:
    arrays = tree_arrays(
        robot(
            *(link(name) for name in "abcdef"),
            joint("a", "b", "continuous"),
            joint("b", "c", "continuous"),
            joint("b", "d", "continuous"),
            joint("c", "e"),
            joint("d", "f", "revolute", more=revolute(-1, 1) + MIMIC),
        ).tree
    )
    number = {name: index for index, name in enumerate(arrays.links)}

    def between(first: str, second: str) -> list[str]:
        return [arrays.axes[at].joint for at in arrays.between(number[first], number[second])]

    assert between("a", "b") == ["a_b"]
    assert between("c", "d") == ["b_c", "b_d"]
    assert between("c", "e") == []
    assert between("d", "f") == ["a_b"]  # which d_f follows


def test_hostile_trees_are_arrays_too() -> None:
    ring = robot(link("a"), link("b"), joint("a", "b"), joint("b", "a"))
    assert tree_arrays(ring.tree).steps == ()
    own = '<mimic joint="a_b"/>'
    mimicry = robot(link("a"), link("b"), joint("a", "b", "continuous", more=own))
    assert [step.column for step in tree_arrays(mimicry.tree).steps] == [-1]
    names = [f"l{number}" for number in range(3000)]
    joints = [joint(a, b, "continuous") for a, b in itertools.pairwise(names)]
    long = tree_arrays(robot(*map(link, names), *joints).tree)
    assert len(long.frames(long.default[None], range(3000))) == 3000
    assert list(long.frames(long.default[None], [7])) == [7]


def test_slopes_are_differences() -> None:
    """Of points fixed to two links, along a direction; a follower counts for its leader."""
    arrays = tree_arrays(
        robot(
            *(link(name) for name in "abcdef"),
            joint("a", "b", "revolute", "1 2 3", revolute(-1, 2, "1 1 0")),
            joint("b", "c", "fixed", "0 1 0"),
            joint("c", "d", "prismatic", "0 0 1", revolute(0, 0.3, "0 2 0")),
            joint("d", "e", "revolute", "0 1 1", revolute(-1, 1) + MIMIC),
            joint("a", "f", "revolute", "1 0 1", revolute(-1, 1)),
        ).tree
    )
    pair, rows = (5, 4), arrays.samples(4, 1, 0)
    columns, branches = arrays.between(*pair), arrays.branches(*pair)
    points, along = np.random.default_rng(3).normal(size=(2, 4, 3))
    frames = arrays.frames(rows, range(6))
    found = slopes(branches, columns, frames, points, along)

    def apart(rows: Any) -> Any:
        """How far the second point is from the first along the direction."""
        ends = arrays.frames(rows, range(6))
        homogeneous = np.append(points, np.ones((4, 1)), axis=1)[:, :, None]
        first, second = (
            (ends[link] @ np.linalg.inv(frames[link]) @ homogeneous)[:, :3, 0] for link in pair
        )
        return np.einsum("ni,ni->n", second - first, along)

    for column, move in enumerate(1e-6 * np.eye(len(columns))):
        change = (apart(rows + move) - apart(rows - move)) / 2e-6
        assert found[:, column] == pytest.approx(change, abs=1e-7)
