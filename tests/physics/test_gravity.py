"""Gravity torques and their largest values against Pinocchio, on random trees."""

from math import isclose

import pytest

pytest.importorskip("pinocchio")

from hypothesis import given, settings
from hypothesis import strategies as st

from tests.output.test_overview import of
from urdfkit import Source, check
from urdfkit.checks.dynamics import dyn003_gravity_exceeds_effort as dyn003
from urdfkit.cli.statics import render
from urdfkit.lint.context import Context
from urdfkit.physics import gravity
from urdfkit.physics.dynamics.statics import statics
from urdfkit.physics.gravity import gravity_loads
from urdfkit.physics.gravity_model import GravityModel
from urdfkit.robot.joint_loads import effort, maximum_loads

lengths = st.floats(-1, 1).map(lambda value: round(value, 3))
vectors = st.tuples(lengths, lengths, lengths)
axes = vectors.filter(lambda axis: max(map(abs, axis)) > 0.1)
kinds = st.sampled_from(["revolute", "continuous", "prismatic", "fixed", "planar", "floating"])


def words(vector: tuple[float, float, float]) -> str:
    return " ".join(map(str, vector))


def efforts(robot: Context) -> dict[str, float | None]:
    return {name: effort(joint) for name, joint in robot.model.joints_by_name.items()}


@st.composite
def trees(draw: st.DrawFn, *, mimics: bool) -> Context:
    """A tree of up to seven links; some joints may mimic others."""
    count = draw(st.integers(2, 7))
    text = ""
    for n in range(count):
        mass = draw(st.floats(0, 5))
        text += (
            f'<link name="l{n}"><inertial><origin xyz="{words(draw(vectors))}"/>'
            f'<mass value="{mass}"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>'
            "</inertial></link>"
        )
    for n in range(1, count):
        law = f'<mimic joint="j{draw(st.integers(1, count - 1))}" multiplier="-0.5" offset="0.1"/>'
        lower = draw(st.floats(-2, 1))
        text += (
            f'<joint name="j{n}" type="{draw(kinds)}"><child link="l{n}"/>'
            f'<parent link="l{draw(st.integers(0, n - 1))}"/><axis xyz="{words(draw(axes))}"/>'
            f'<origin xyz="{words(draw(vectors))}" rpy="{words(draw(vectors))}"/>'
            f'<limit lower="{lower}" upper="{lower + draw(st.floats(0, 3))}" effort="1" '
            f'velocity="1"/>{law if mimics and draw(st.booleans()) else ""}</joint>'
        )
    return of(text)


@given(trees(mimics=True), st.floats(-3, 3))
def test_torques_are_those_of_pinocchio(robot: Context, place: float) -> None:
    pose = {
        name: place * (number + 1) / 7 for number, name in enumerate(robot.model.joints_by_name)
    }
    dynamics = robot.dynamics
    settable = {name: value for name, value in pose.items() if name in dynamics.columns}
    exact = dict(zip(dynamics.columns, dynamics.gravity(settable), strict=True))
    for name, torque in GravityModel(robot.tree).torques(pose).items():
        assert torque == pytest.approx(exact[name], abs=1e-9)


@settings(max_examples=60, deadline=None)
@given(trees(mimics=False), st.integers(0, 10**6))
def test_no_pose_is_worse_and_the_bound_holds(robot: Context, seed: int) -> None:
    """Of 200 drawn poses none is worse than what the search finds, which the bound is not below."""
    model = GravityModel(robot.tree)
    bound = maximum_loads(robot.tree)
    drawn = [model.torques(pose) for pose in model.starts(200, seed)]
    for load in gravity_loads(model, efforts(robot), model.starts(20, 0), pose={}):
        torques = [abs(torque[load.joint]) for torque in drawn[1:]]  # zero may be beyond limits
        assert max(torques) <= load.worst * (1 + 1e-6) + 1e-9
        assert load.worst <= bound[load.joint] * (1 + 1e-9) + 1e-9
        at_worst = robot.dynamics.gravity(load.pose)[robot.dynamics.columns.index(load.joint)]
        rested = {**dict.fromkeys(load.pose, 0.0), **load.pose}
        assert rested == load.pose
        assert isclose(abs(at_worst), load.worst, rel_tol=2e-4, abs_tol=1e-9)


@settings(max_examples=30, deadline=None)
@given(trees(mimics=True))
def test_the_bound_holds_for_joints_that_others_mimic(robot: Context) -> None:
    model = GravityModel(robot.tree)
    bound = maximum_loads(robot.tree)
    for load in gravity_loads(model, efforts(robot), model.starts(20, 0), pose={}):
        assert load.worst <= bound[load.joint] * (1 + 1e-9) + 1e-9


def test_a_payload_and_links_without_weight() -> None:
    arm = of(
        '<link name="a"/><link name="b"><inertial><origin xyz="1 0 0"/><mass value="2"/></inertial>'
        '</link><joint name="j" type="continuous"><parent link="a"/><child link="b"/>'
        '<axis xyz="0 1 0"/></joint><link name="tip"/><joint name="k" type="fixed">'
        '<parent link="b"/><child link="tip"/><origin xyz="2 0 0"/></joint>'
    )
    assert GravityModel(arm.tree).torques({}) == {"j": pytest.approx(-2 * 9.81)}
    assert GravityModel(arm.tree, {"tip": 1.0}).torques({}) == {"j": pytest.approx(-4 * 9.81)}
    assert GravityModel(arm.tree, weightless={"b"}).torques({}) == {"j": pytest.approx(0)}


def test_more_joints_than_are_searched_have_their_load_at_zero(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    body = (
        '<link name="l{0}"><inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" '
        'iyz="0" izz="1"/></inertial></link>'
    )
    joint = (
        '<joint name="j{0}" type="continuous"><parent link="l{0}"/><child link="l{1}"/>'
        '<origin xyz="0 0 1"/><axis xyz="1 0 0"/></joint>'
    )
    text = "".join(body.format(n) for n in range(4))
    context = of(text + "".join(joint.format(n, n + 1) for n in range(3)))
    model = GravityModel(context.tree)
    starts = model.starts(3, seed=0)
    searched = gravity_loads(model, efforts(context), starts, pose={})
    assert max(load.worst for load in searched) == pytest.approx(3 * 9.81)  # 1 and 2 m away
    monkeypatch.setattr(gravity, "MAX_SEARCHED", 2)
    loads = gravity_loads(model, efforts(context), starts, pose={})
    assert [(load.worst, load.pose) for load in loads] == [(0, {})] * 3  # the chain is upright
    found = statics(context.dynamics)
    assert not found.searched
    assert "zero pose only" in next(render(found, context.model))


def test_the_rule_says_that_it_does_not_search(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(gravity, "MAX_SEARCHED", 0)
    text = f'<robot name="r">{dyn003.BAD}</robot>'
    report = check(Source("r.urdf", text.encode()), select=["DYN003"])
    assert [skip.code for skip in report.skipped] == ["DYN003"]
