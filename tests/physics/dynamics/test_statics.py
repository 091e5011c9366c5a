"""Gravity torques over a pose set: closed forms of the worst pose, and no sample is worse."""

from math import pi, sin

import pytest

np = pytest.importorskip("numpy")
pytest.importorskip("pinocchio")

from tests.conftest import CORPUS, MODELS, needs_corpus
from tests.jointed import mimic
from tests.massive import inertial, link
from tests.physics.dynamics.test_robot import dynamics, moving
from urdfkit.lint.loading import read
from urdfkit.physics.dynamics.robot import Dynamics
from urdfkit.physics.dynamics.statics import statics

G = 9.81
ARM = read(MODELS / "good" / "two_link_arm" / "urdf" / "two_link_arm.urdf")


def test_a_two_link_arm_stretched_as_far_out_as_its_limits_let_it() -> None:
    """The shoulder stops at 1.5 rad; the elbow makes the forearm level: pi / 2 - 1.5."""
    found = statics(ARM.dynamics)
    shoulder = found.loads[0]
    expected = G * ((1.5 * 0.15 + 0.7 * 0.36) * sin(1.5) + 0.7 * 0.125)
    assert shoulder.joint == "shoulder"
    assert shoulder.worst == pytest.approx(expected, rel=1e-10)
    assert abs(shoulder.pose["shoulder"]) == 1.5
    assert abs(sum(shoulder.pose.values())) == pytest.approx(pi / 2)
    assert shoulder.used == pytest.approx(expected / 20)
    assert found.weakest == shoulder
    assert not shoulder.is_exceeded
    elbow = found.loads[1]
    assert elbow.worst == pytest.approx(G * 0.7 * 0.125, rel=1e-10)


def test_a_payload_exceeds_the_effort_and_what_would_suffice_is_reported() -> None:
    found = statics(Dynamics(ARM.tree, {"forearm": 5.0}))
    shoulder = found.loads[0]
    expected = G * ((1.5 * 0.15 + 5.7 * 0.36) * sin(1.5) + 0.7 * 0.125)
    assert shoulder.is_exceeded
    assert shoulder.worst == pytest.approx(expected, rel=1e-10)
    assert found.mass == pytest.approx(10.2)
    assert found.payload == {"forearm": 5.0}


def test_a_pose_that_is_asked_for() -> None:
    """The arm at 0.5 rad, with the forearm upright."""
    loads = {
        one.joint: one for one in statics(ARM.dynamics, {"shoulder": 0.5, "elbow": -0.5}).loads
    }
    shoulder, elbow = loads["shoulder"], loads["elbow"]
    assert shoulder.at_pose == pytest.approx(-G * (1.5 * 0.15 + 0.7 * 0.36) * sin(0.5), rel=1e-10)
    assert [elbow.at_pose, shoulder.at_zero] == pytest.approx([0, 0], abs=1e-12)


def test_the_search_finds_what_no_sample_does() -> None:
    found = statics(ARM.dynamics, samples=0)
    assert found.loads[0].worst == pytest.approx(statics(ARM.dynamics).loads[0].worst, rel=1e-10)


def test_the_same_seed_gives_the_same_poses() -> None:
    first, again, other = (statics(ARM.dynamics, seed=seed) for seed in (1, 1, 2))
    assert first == again
    assert first.loads[0].worst == pytest.approx(other.loads[0].worst, rel=1e-10)


def test_a_slide_and_a_joint_without_effort() -> None:
    text = link("base", inertial(1, (1, 1, 1))) + link("cage", inertial(4, (1, 1, 1)))
    text += moving("base", "cage", "prismatic", "0 0 1").replace('effort="10"', 'effort="0"')
    (load,) = statics(dynamics(text)).loads
    assert load.worst == pytest.approx(4 * G)
    assert (load.effort, load.used) == (None, None)
    assert statics(dynamics(text)).weakest is None


def test_a_lever_on_a_slide_is_worst_at_its_end() -> None:
    """A mass that slides out to 3 m on an arm that turns: linear in the slide."""
    text = link("base", inertial(1, (1, 1, 1))) + link("arm", inertial(1, (1, 1, 1)))
    text += link("slider", inertial(2, (1, 1, 1))) + moving("base", "arm", "continuous", "0 1 0")
    text += moving("arm", "slider", "prismatic", "1 0 0")
    found = {load.joint: load for load in statics(dynamics(text), samples=0).loads}
    assert found["arm_joint"].worst == pytest.approx(2 * G * 3, rel=1e-10)
    assert abs(found["arm_joint"].pose["slider_joint"]) == 3


def test_a_leader_holds_what_follows_it() -> None:
    ball = inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    text = link("base", inertial(1, (1, 1, 1))) + link("a", ball) + link("b", ball)
    text += moving("base", "a", "continuous", "0 1 0")
    text += moving("base", "b", "continuous", "0 1 0", more=mimic("a_joint"))
    (load,) = statics(dynamics(text)).loads
    assert load.worst == pytest.approx(2 * 2 * G * 0.5, rel=1e-2)


def test_a_chain_of_a_hundred_joints_is_bounded() -> None:
    number = 100
    text = link("l0") + "".join(
        link(f"l{n + 1}", inertial(1, (1, 1, 1), xyz="0.1 0 0"))
        + moving(f"l{n}", f"l{n + 1}", "revolute", "0 1 0", xyz="0.1 0 0")
        for n in range(number)
    )
    robot = dynamics(text)
    assert robot.data is not None  # large, and made once
    reported: list[tuple[int, int]] = []
    found = statics(
        robot, samples=2000, progress=lambda done, total: reported.append((done, total))
    )
    assert len(found.loads) == number
    # All links in one level row: the sum of 0.1 n for n from 1 to 100.
    assert found.loads[0].worst == pytest.approx(G * 0.1 * number * (number + 1) / 2, rel=0.05)
    assert reported == sorted(reported)
    assert all(done < total for done, total in reported)


def test_the_worst_pose_names_what_matters_to_it() -> None:
    """A lever on one side, whose torque no other joint changes; one of them cannot be at 0."""
    ball = inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    text = link("base", inertial(1, (1, 1, 1))) + link("a", ball) + link("b", ball) + link("c")
    text += moving("base", "a", "continuous", "0 1 0") + moving("base", "b", "continuous", "0 1 0")
    bounded = moving("base", "c", "revolute", "0 1 0")
    text += bounded.replace('lower="-3"', 'lower="0.5"')
    assert 'lower="0.5"' in text
    for load in statics(dynamics(text), {"b_joint": 1.0}).loads:
        assert set(load.pose) <= {load.joint}


@pytest.mark.parametrize("axis", ["0 0 1", "0 0 -1"])
def test_no_torque_has_no_sign(axis: str) -> None:
    """inmoov's waist used -0 % of its effort."""
    text = link("base") + link("a", inertial(2, (0.1, 0.1, 0.1), xyz="0.3 -0.2 0.1"))
    text += link("b", inertial(1, (0.1, 0.1, 0.1), xyz="0.1 0.3 0.1"))
    text += moving("base", "a", "revolute", axis) + moving("a", "b", "revolute", "0 1 0")
    load = next(one for one in statics(dynamics(text)).loads if one.joint == "a_joint")
    assert (str(load.worst), str(load.used)) == ("0.0", "0.0")


def test_nothing_to_hold() -> None:
    found = statics(dynamics(link("base", inertial(1, (1, 1, 1)))))
    assert (found.loads, found.weakest) == ((), None)


@needs_corpus
def test_no_sample_of_a_real_arm_is_worse() -> None:
    file = CORPUS / "Universal_Robots_ROS2_Description" / "urdf" / "ur.urdf.xacro"
    arm = read(file, arguments={"name": "ur", "ur_type": "ur5e"}).dynamics
    found = {load.joint: load for load in statics(arm, samples=100).loads}
    random = np.random.default_rng(7)
    drawn = random.uniform(-pi, pi, (3000, arm.nv))
    torques = np.abs([arm.gravity(dict(zip(arm.columns, x, strict=True))) for x in drawn]).max(
        axis=0
    )
    for name, torque in zip(arm.columns, torques, strict=True):
        assert torque <= found[name].worst * (1 + 1e-9) + 1e-9
        at_worst = arm.gravity(found[name].pose)[arm.columns.index(name)]
        assert abs(at_worst) == pytest.approx(found[name].worst, rel=1e-9, abs=1e-9)
    assert 0.3 < found["shoulder_lift_joint"].used < 0.6  # type: ignore[operator]


def test_limits_that_are_beyond_all_robots_are_no_trouble() -> None:
    """A slide of 1e308 m, and a follower by a factor of 1e308: neither warns nor fails."""
    ball = inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    text = link("base") + link("a", ball) + link("b", ball) + link("c", ball)
    slide = moving("base", "a", "prismatic", "0 0 1")
    text += slide.replace('"-3"', '"-1e308"').replace('"3"', '"1e308"')
    text += moving("a", "b", "revolute", "0 1 0")
    text += moving("b", "c", "revolute", "0 1 0", more=mimic("b_joint", 'multiplier="1e308"'))
    assert "1e308" in text.partition("multiplier")[0]
    loads = {load.joint: load.worst for load in statics(dynamics(text), samples=100).loads}
    assert loads["a_joint"] == pytest.approx(6 * G)
    assert loads["b_joint"] == pytest.approx(2 * G * (0.5 + 0.5))  # c stands still at its place


def test_only_the_joints_that_are_asked_for_are_judged() -> None:
    """Of a joint of several coordinates there is nothing to judge."""
    ball = inertial(2, (0.1, 0.1, 0.1), xyz="0.5 0 0")
    text = link("base") + link("a", ball) + link("b", ball) + link("c", ball)
    text += moving("base", "a", "revolute", "0 1 0") + moving("base", "b", "revolute", "0 1 0")
    robot = dynamics(text + moving("base", "c", "planar", "0 1 0"))
    assert {load.joint for load in statics(robot, samples=10).loads} == {"a_joint", "b_joint"}
    (load,) = statics(robot, samples=10, joints=["b_joint", "c_joint[1]"]).loads
    assert load.joint == "b_joint"
    assert load.worst == pytest.approx(2 * G * 0.5)


def test_a_torque_that_pulls_the_other_way_is_climbed_downwards() -> None:
    """The lever hangs at -x, so that gravity pulls its joint to the other side at zero."""
    far = inertial(2, (0.1, 0.1, 0.1), xyz="-0.5 0 0")
    text = link("base") + link("a") + link("b", far)
    text += moving("base", "a", "revolute", "0 1 0")
    text += moving("a", "b", "revolute", "0 1 0", xyz="-0.5 0 0")
    loads = {load.joint: load for load in statics(dynamics(text), samples=0).loads}
    assert loads["a_joint"].at_zero == pytest.approx(2 * G)
    assert loads["a_joint"].worst == pytest.approx(2 * G)
    assert loads["b_joint"].worst == pytest.approx(2 * G * 0.5)


@pytest.mark.parametrize(("lower", "upper"), [("-5", "-4.4"), ("4.4", "5"), ("1.4", "2")])
def test_the_top_of_a_torque_is_found_a_turn_away(lower: str, upper: str) -> None:
    """The lever is level between the limits, and at neither of them."""
    text = link("base") + link("a", inertial(2, (0.1, 0.1, 0.1), xyz="0 0 0.5"))
    swing = moving("base", "a", "revolute", "0 1 0")
    text += swing.replace('lower="-3"', f'lower="{lower}"').replace('upper="3"', f'upper="{upper}"')
    (load,) = statics(dynamics(text), samples=0).loads
    assert load.worst == pytest.approx(2 * G * 0.5, rel=1e-9)
    assert abs(sin(load.pose["a_joint"])) == pytest.approx(1)
