import pytest

from tests.conftest import CorpusRobot, manifest, model_id, needs_corpus
from tests.massive import BALL, MESH, context, inertial, joint, link, masses, part, shape
from urdfkit.lint import engine
from urdfkit.robot.inertials.link_comparison import by_tensor
from urdfkit.robot.inertials.masses import unlike

PLAIN = [entry for entry in manifest() if entry.facts["kind"] == "urdf"]
EXPANDABLE = [entry for entry in manifest() if "mujoco_prepared" in entry.facts.get("expect", ())]
BALANCED = (0.004, 0.004, 0.004)


@pytest.mark.parametrize(
    ("moments", "found"),
    [
        ((0, 1, 1), True),
        ((1e-9, 1, 1), True),
        ((1.1e-9, 1, 1), False),
        ((0, 1e-15, 1e-15), False),  # INE005 tells that there is none at all
        ((0, 1.1e-15, 1.1e-15), True),
    ],
)
def test_a_body_is_singular_if_it_has_no_moment_about_one_axis(
    moments: tuple[float, float, float], found: bool
) -> None:
    robot = link("base", inertial(1, (1, 1, 1))) + link("rod", inertial(1, moments))
    assert bool(masses(robot + joint("base", "rod", "revolute")).singular) == found
    assert not masses(robot + joint("base", "rod")).singular


def test_the_moments_of_a_body_and_what_matters() -> None:
    found = masses(
        part("base", 1, (0.1, 0.2, 0.25), BALL)
        + part("mast", 1, (0.1, 0.2, 0.25), BALL)
        + joint("base", "mast", xyz="0 0 2")
    )
    (body,) = found.bodies
    assert found.moments_of(body) == pytest.approx((0.5, 2.2, 2.4))
    assert found.is_significant(body, 0.0241)
    assert not found.is_significant(body, 0.0239)


def test_a_counterpart_hangs_where_its_counterpart_hangs() -> None:
    arms = "".join(
        part(f"{side}_{name}", 1, BALANCED, BALL)
        for side in ("left", "right")
        for name in ("arm", "hand")
    )
    good = (
        arms
        + link("torso")
        + joint("torso", "left_arm")
        + joint("torso", "right_arm")
        + joint("left_arm", "left_hand")
        + joint("right_arm", "right_hand")
    )
    assert names(good) == [("left_arm", "right_arm"), ("left_hand", "right_hand")]
    odd = good.replace('<parent link="right_arm"/>', '<parent link="torso"/>')
    assert names(odd) == [("left_arm", "right_arm")]


def test_numbered_links_are_counterparts_if_they_mirror_each_other() -> None:
    robot = link("base") + "".join(
        part(f"wheel_{i}", 1, BALANCED, BALL) + joint("base", f"wheel_{i}", "continuous", xyz)
        for i, xyz in enumerate(("0.1 0.2 0", "0.1 -0.2 0", "0.1 -0.3 0"))
    )
    assert names(robot) == [("wheel_0", "wheel_1")]


def names(robot: str) -> list[tuple[str, str]]:
    return [(left.link.name, right.link.name) for left, right in masses(robot).symmetric_pairs]


@pytest.mark.parametrize(
    ("mass", "moments", "expected"),
    [
        (1, (1, 1, 1), ""),
        (1.19, (1, 1, 1), ""),
        (1.21, (1, 1, 1), "mass"),
        (0.8, (2, 2, 2), "mass"),
        (1, (1, 1, 1.49), ""),
        (1, (1, 1, 1.51), "inertia"),
        (1, (0.6, 1, 1), "inertia"),
    ],
)
def test_in_what_two_links_differ(mass: float, moments: tuple[float, ...], expected: str) -> None:
    one, other = masses(part("a", 1, (1, 1, 1), BALL) + part("b", mass, moments, BALL)).inertias
    assert unlike(one, other) == unlike(other, one) == expected


def test_a_moment_that_is_next_to_nothing_may_differ() -> None:
    robot = part("a", 1, (1, 1, 1e-5), BALL) + part("b", 1, (1, 1, 9e-3), BALL)
    one, other = masses(robot).inertias
    assert unlike(one, other) == ""


def test_groups_keep_the_order_of_the_document() -> None:
    robot = "".join(part(f"l{i}", 1, (1 + i % 2,) * 3, BALL) for i in range(4))
    groups = by_tensor(masses(robot).inertias)
    assert [[one.link.name for one in group] for group in groups] == [["l0", "l2"], ["l1", "l3"]]


@pytest.mark.parametrize(
    "joints",
    [
        joint("a", "b") + joint("b", "a"),
        joint("a", "b", "continuous") + joint("b", "a", "continuous"),
        joint("a", "a"),
        joint("x", "b"),
        joint("c", "b") + joint("a", "b"),
    ],
)
def test_every_graph_and_every_number(joints: str) -> None:
    robot = (
        part("a", 1, BALANCED, BALL)
        + part("b", 1e300, (1e300, -1e300, 1e-300), BALL, xyz="1e300 0 0")
        + part("b", -1, BALANCED, BALL)
        + link("c", shape("collision", MESH), inertial(0, (0, 0, 0)))
        + joints
    )
    report = engine.check(context(robot).source, select=["INE", "GEO"])
    assert report.crashed == ()


@needs_corpus
@pytest.mark.parametrize("entry", EXPANDABLE, ids=model_id)
def test_mujoco_refuses_what_breaks_the_triangle_inequality(
    entry: CorpusRobot,
) -> None:
    """MuJoCo names the first body that it refuses, and stops there."""
    verdict = entry.facts["expect"]["mujoco_prepared"]
    report = engine.check(entry.path, arguments=entry.arguments, select=["INE003"])
    found = [diagnostic for diagnostic in report.diagnostics if diagnostic.code == "INE003"]
    reported = [diagnostic.element.split("/")[1] for diagnostic in found]
    notes = [note.message for diagnostic in found for note in diagnostic.related]
    if "A + B >= C" in verdict:
        name = verdict.split("Element name '")[1].split("'")[0]
        assert name in reported or any(f"link '{name}'" in note for note in notes)
    elif verdict == "ok":
        assert reported == []
