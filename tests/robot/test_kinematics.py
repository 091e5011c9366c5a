"""Where links are at a configuration; what follows what."""

from math import cos, pi, sin, sqrt

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.conftest import ARM, GRIPPER
from tests.documents import tree
from tests.growth import executed_lines
from tests.jointed import joint, mimic, robot
from urdfkit.core.spatial import from_rpy, rotation_about, to_rpy
from urdfkit.lint.loading import load, read
from urdfkit.robot.kinematics import (
    MimicLaw,
    direction,
    frames,
    laws,
    motion,
    positions,
    transform,
)
from urdfkit.robot.model import UnknownLink
from urdfkit.robot.tree import KinematicTree


def test_a_chain_of_followers_in_any_order() -> None:
    """c = 2 b + 1 and b = -3 a + 0.5 make c = -6 a + 2."""
    text = robot(
        joint("c", "continuous", mimic("b", 'multiplier="2" offset="1"')),
        joint("b", "continuous", mimic("a", 'multiplier="-3" offset="0.5"')),
        joint("a", "continuous"),
    )
    model = tree(text)
    assert laws(model.model.joints_by_name) == {
        "a": MimicLaw("a", 1.0, 0.0),
        "b": MimicLaw("a", -3.0, 0.5),
        "c": MimicLaw("a", -6.0, 2.0),
    }
    assert positions(model, {"a": 0.25, "b": 9.0}) == {"a": 0.25, "b": -0.25, "c": 0.5}


def test_what_follows_nobody_that_is_there_stands_still() -> None:
    text = robot(
        joint("a", "continuous", mimic("b", 'offset="1"')),
        joint("b", "continuous", mimic("a", 'offset="1"')),
        joint("hanger", "continuous", mimic("a", 'offset="1"')),
        joint("own", "continuous", mimic("own", 'offset="1"')),
        joint("orphan", "continuous", mimic("nobody", 'offset="1"')),
    )
    expected = {"a": 0.0, "b": 0.0, "hanger": 0.0, "own": 0.0, "orphan": 1.0}
    assert positions(tree(text), {"a": 1.0, "own": 1.0}) == expected


def test_numbers_that_overflow_stand_still() -> None:
    big = 'multiplier="1e200" offset="1e308"'
    text = robot(
        joint("a", "continuous"),
        joint("b", "continuous", mimic("a", big)),
        joint("c", "continuous", mimic("b", big)),
    )
    assert positions(tree(text), {"a": 1.0})["c"] == 0.0
    assert len(frames(tree(text), {"a": 1.0})) == 4


def test_a_position_that_overflows_is_zero() -> None:
    text = robot(joint("a", "continuous"), joint("b", "continuous", mimic("a", 'multiplier="10"')))
    assert positions(tree(text), {"a": 1e308}) == {"a": 1e308, "b": 0.0}


def test_an_axis_that_is_not_written_is_x() -> None:
    """So URDF has it; one without a direction counts as not written."""
    for axis in ("", '<axis xyz="0 0 0"/>', '<axis xyz="2 0 0"/>'):
        one = tree(robot(joint("a", "continuous", axis))).model.joints_by_name["a"]
        assert direction(one) == (1, 0, 0)
        assert motion(one, pi / 2).apply((0, 1, 0)) == pytest.approx((0, 0, 1))


def test_followers_in_a_row_take_linear_time() -> None:
    def lines(number: int) -> int:
        row = tree(
            robot(
                *(joint(f"j{i}", "continuous", mimic(f"j{i - 1}")) for i in range(number, 0, -1)),
                joint("j0", "continuous"),
            )
        )
        assert set(positions(row, {"j0": 0.5}).values()) == {0.5}
        return executed_lines(lambda: positions(row, {"j0": 0.5}))

    assert lines(1000) < 110 * lines(10)


@pytest.mark.parametrize("q", [(0.0, 0.0), (0.3, -0.7), (pi / 2, pi / 3), (-1.5, 1.9)])
def test_a_two_link_arm_by_its_closed_form(q: tuple[float, float]) -> None:
    """It swings about y: its links stand at 0.145 m, and 0.36 m along the upper arm."""
    arm = read(ARM).tree
    found = frames(arm, {"shoulder": q[0], "elbow": q[1]})
    both, position = found["forearm"]
    c, s = cos(q[0] + q[1]), sin(q[0] + q[1])
    expected = ((c, 0, s), (0, 1, 0), (-s, 0, c))
    assert all(row == pytest.approx(e, abs=1e-15) for row, e in zip(both, expected, strict=True))
    elbow = (0.36 * sin(q[0]), 0, 0.145 + 0.36 * cos(q[0]))
    assert position == pytest.approx(elbow, abs=1e-15)
    assert found["upper_arm"].position == (0, 0, 0.145)


def test_a_rotation_about_a_slanting_axis_is_a_sum_of_turns() -> None:
    """A third of a turn about the diagonal takes x to y, y to z and z to x."""
    part = 1 / sqrt(3)
    rows = rotation_about((part, part, part), 2 * pi / 3)
    expected = ((0, 0, 1), (1, 0, 0), (0, 1, 0))
    assert all(row == pytest.approx(e, abs=1e-15) for row, e in zip(rows, expected, strict=True))


def test_a_slide_and_an_axis_that_is_no_unit_vector() -> None:
    text = robot(joint("a", "prismatic", '<axis xyz="0 0 10"/>'))
    assert frames(tree(text), {"a": 0.2})["a_link"].position == (0.0, 0.0, 0.2)


def test_the_gripper_s_fingers_move_together() -> None:
    model = load(GRIPPER)
    both = KinematicTree(model)
    (leader,) = (joint.name for joint in model.joints if joint.degrees_of_freedom)
    moved = positions(both, {leader: 0.01})
    assert set(map(abs, moved.values())) == {0.01}


def test_a_link_seen_from_another_one() -> None:
    """From the forearm, turned by a right angle, the base is behind and beside it."""
    arm = read(ARM).tree
    pose = {"shoulder": pi / 2}
    seen = transform(arm, pose, "base", "forearm")
    assert seen.position == pytest.approx((0.145, 0, -0.36), abs=1e-15)
    back = seen @ transform(arm, pose, "forearm", "base")
    assert back.position == pytest.approx((0, 0, 0), abs=1e-15)


def test_where_no_link_is_and_no_way_leads() -> None:
    two = tree('<link name="a"/><link name="b"/>')
    with pytest.raises(UnknownLink, match="links 'a' and 'b' are not connected by joints"):
        transform(two, {}, "b", "a")
    with pytest.raises(UnknownLink, match="no link 'armm'; did you mean 'arm'"):
        transform(tree('<link name="arm"/>'), {}, "armm", "arm")


@given(st.tuples(*[st.floats(-pi, pi)] * 3))
def test_roll_pitch_and_yaw_come_back_as_the_same_rotation(angles: tuple[float, ...]) -> None:
    rotation = from_rpy(*angles)
    again = from_rpy(*to_rpy(rotation))
    for row, other in zip(rotation, again, strict=True):
        assert row == pytest.approx(other, abs=1e-8)


@pytest.mark.parametrize("pitch", [pi / 2, -pi / 2])
def test_a_pitch_of_a_right_angle_has_no_yaw(pitch: float) -> None:
    rotation = from_rpy(0.3, pitch, -0.8)
    roll, found, yaw = to_rpy(rotation)
    assert [found, yaw] == pytest.approx([pitch, 0])
    for row, other in zip(rotation, from_rpy(roll, found, yaw), strict=True):
        assert row == pytest.approx(other, abs=1e-12)
