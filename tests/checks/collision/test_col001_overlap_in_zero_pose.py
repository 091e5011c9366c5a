"""COL001: see the rule."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

from tests.physics.collision.robots import box, joint, link, revolute, sphere
from tests.reported import messages, places
from urdfkit.core import libraries
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.source import Source

SWING = revolute(-2, 2, "0 1 0")


def bent(depth: float, limits: str = SWING, between: str = box(0.05, 0.05, 0.4)) -> str:
    """A ball on an arm that reaches so deep into the base where it hangs down."""
    return "\n".join(
        (
            link("base", box(0.2, 0.2, 0.2)),
            link("upper", f"{between}@0 0 0.35"),
            link("tool", f"{sphere(0.05)}@0 0 {-0.35 - depth}"),
            joint("base", "upper", "revolute", "0 0 0.1", revolute(-1, 1, "0 1 0")),
            joint("upper", "tool", "revolute", "0 0 0.4", limits),
        )
    )


@pytest.fixture(autouse=True)
def _needs_coal(request: pytest.FixtureRequest) -> None:
    if "without" not in request.node.name:
        pytest.importorskip("coal")


@pytest.mark.parametrize("kind", ["floating", "planar"])
def test_what_no_joint_binds_is_nowhere(kind: str) -> None:
    """Neither the trees of two roots nor what floats stands at the origin of the other."""
    arm = bent(0.004)
    assert messages("COL001", arm)
    assert not messages("COL001", arm.replace("revolute", kind, 1))
    assert not messages("COL001", arm.partition("<joint")[0])


def test_the_depth_and_the_smaller_body() -> None:
    text = bent(0.004)
    assert messages("COL001", text) == [
        "links 'tool' and 'base' overlap by 4 mm where all joints are at zero"
    ]
    ((line, what),) = places("COL001", text)
    assert (line, what) == (4, "<collision>")


@pytest.mark.parametrize("depth", [-0.1, 0, 0.0005])
def test_less_than_a_millimetre_is_no_matter(depth: float) -> None:
    assert messages("COL001", bent(depth)) == []


def test_a_joint_that_begins_elsewhere() -> None:
    assert messages("COL001", bent(0.02, revolute(1, 2, "0 1 0"))) == []


def test_what_collides_in_every_pose_is_told_by_another_rule() -> None:
    stiff = bent(0.02).replace('lower="-2" upper="2"', 'lower="0" upper="0"')
    assert messages("COL001", stiff) == []
    assert len(messages("COL002", stiff)) == 1


def test_neighbours_and_rigid_links_are_no_matter() -> None:
    arm = link("base", box(0.2, 0.2, 0.2)) + link("arm", box(0.2, 0.2, 0.2))
    assert messages("COL001", arm + joint("base", "arm", "continuous")) == []
    sensor = link("mid", box(0.1, 0.1, 0.1)) + link("eye", box(0.1, 0.1, 0.1))
    fixed = joint("base", "arm", origin="9 0 0") + joint("arm", "mid") + joint("mid", "eye")
    assert messages("COL001", arm + sensor + fixed) == []


def test_without_coal_it_is_skipped_with_the_remedy(monkeypatch: pytest.MonkeyPatch) -> None:
    original = libraries.find
    monkeypatch.setattr(libraries, "find", lambda name: None if name == "coal" else original(name))
    for module in [name for name in sys.modules if name.startswith("urdfkit.physics.collision")]:
        monkeypatch.delitem(sys.modules, module)
    source = Source("r.urdf", whole_robot(bent(0.02)).encode())
    report = engine.check(source, select=["COL"])
    assert report.diagnostics == ()
    assert {skip.code for skip in report.skipped} == {
        "COL001", "COL002", "COL003", "COL004", "COL006",
    }  # fmt: skip
    assert {skip.reason for skip in report.skipped} == {
        "coal is not installed: pip install 'urdfkit[dynamics]'"
    }
    assert not any(name.startswith("urdfkit.physics.collision") for name in sys.modules)


def test_the_arm_of_moveit_is_folded_into_itself_at_zero(corpus: Path) -> None:
    panda = corpus / "moveit_resources" / "panda_description" / "urdf" / "panda.urdf"
    found = engine.check(panda, select=["COL001"]).diagnostics
    assert [one.message.split(" overlap")[0] for one in found] == [
        "links 'panda_link7' and 'panda_link5'",
        "links 'panda_hand' and 'panda_link5'",
    ]


@pytest.mark.parametrize(("limits", "reported"), [(revolute(1, 2), 0), (revolute(-1, 2), 1)])
def test_a_joint_above_both_that_cannot_be_at_zero(limits: str, reported: int) -> None:
    below = bent(0.004) + link("stand") + joint("stand", "base", "revolute", more=limits)
    assert len(messages("COL001", below)) == reported
