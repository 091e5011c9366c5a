"""The upper bound of what gravity asks: never under the truth, and cheap."""

import pytest

from tests.conftest import ARM, CORPUS, needs_corpus
from tests.documents import tree
from tests.growth import executed_lines
from tests.massive import BALL, inertial, link, shape
from urdfkit.lint.loading import read
from urdfkit.robot.inertia import MassProperties
from urdfkit.robot.joint_loads import (
    effort,
    is_effort_excessive,
    joints_without_load,
    light_joints,
    maximum_loads,
    overloadable_joints,
)
from urdfkit.robot.link import Tensor


def swinging(name: str, parent: str, effort: str, xyz: str = "0 0 0") -> str:
    return (
        f'<joint name="{name}_joint" type="revolute"><origin xyz="{xyz}"/><parent link="{parent}"/>'
        f'<child link="{name}"/><axis xyz="0 1 0"/>'
        f'<limit lower="-3" upper="3" effort="{effort}" velocity="1"/></joint>'
    )


def pendulum(effort: str) -> str:
    bob = link("bob", inertial(2, (0.01, 0.01, 0.01), xyz="0 0 -0.7"))
    return link("base") + bob + swinging("bob", "base", effort)


def test_the_bound_of_a_pendulum_is_its_worst_pose() -> None:
    assert maximum_loads(tree(pendulum("1"))) == {
        "bob_joint": pytest.approx(2 * 9.81 * 0.7, rel=1e-15)
    }


@pytest.mark.parametrize(("limit", "found"), [("13.7", 1), ("13.8", 0), ("0", 0), ("-1", 0)])
def test_joints_that_may_be_overloaded(limit: str, found: int) -> None:
    assert len(overloadable_joints(tree(pendulum(limit)))) == found


def test_an_effort_of_zero_says_nothing() -> None:
    joints = tree(pendulum("0")).model.joints_by_name
    assert effort(joints["bob_joint"]) is None


@pytest.mark.parametrize(
    ("moments", "center", "effort", "is_found"),
    [
        ((1e-3, 1e-9, 1e-3), (0.0, 0.0, 0.0), "54", True),  # about y
        ((1e-9, 1e-3, 1e-9), (0.0, 0.0, 0.0), "54", False),
        ((1e-9, 1e-9, 1e-9), (0.0, 0.1, 0.0), "54", True),
        ((1e-9, 1e-9, 1e-9), (0.0, 0.0, 0.1), "54", False),
        ((1e-9, 1e-9, 1e-9), (0.0, 0.0, 0.0), "0.04", False),
        ((1e-9, 1e-9, 1e-9), (0.0, 0.0, 0.0), "0.06", True),
    ],
)
def test_an_effort_that_throws_what_it_moves(
    moments: tuple[float, float, float],
    center: tuple[float, float, float],
    effort: str,
    is_found: bool,
) -> None:
    (joint,) = tree(pendulum(effort)).model.joints
    x, y, z = moments
    moved = MassProperties(0.001, center, Tensor(x, 0.0, 0.0, y, 0.0, z))
    assert is_effort_excessive(joint, moved) is is_found


def test_what_is_no_tree_has_no_loads() -> None:
    assert overloadable_joints(tree(link("a") + link("b"))) == []


@pytest.mark.parametrize(
    "content",
    [inertial(1, (1, 1, 1)), shape("visual", BALL), shape("collision", BALL)],
    ids=["mass", "visual", "collision"],
)
def test_a_joint_is_idle_if_nothing_below_it_is_anything(content: str) -> None:
    """Whatever it is that a link has, the joints above it move something."""
    text = link("base") + link("a") + link("b", content) + link("c")
    text += swinging("a", "base", "1") + swinging("b", "a", "1") + swinging("c", "b", "1")
    assert [joint.name for joint in joints_without_load(tree(text))] == ["c_joint"]


def test_what_follows_or_is_fixed_is_not_idle() -> None:
    text = link("base") + link("a") + link("b")
    text += swinging("a", "base", "1") + swinging("b", "a", "1").replace(
        "</joint>", '<mimic joint="a_joint"/></joint>'
    )
    assert [joint.name for joint in joints_without_load(tree(text))] == ["a_joint"]
    assert joints_without_load(tree(text.replace("revolute", "fixed"))) == []
    assert joints_without_load(tree(link("a") + link("b"))) == []


def test_a_body_is_light_beside_what_it_carries() -> None:
    """At a ten-thousandth of it; what weighs as much as all below it, or nothing below, is not."""

    def arm(middle: float, tip: float) -> list[str]:
        text = link("base") + link("m", inertial(middle, (1, 1, 1)))
        text += link("t", inertial(tip, (1, 1, 1)))
        text += swinging("m", "base", "1") + swinging("t", "m", "1")
        return [joint.name for joint in light_joints(tree(text))]

    assert arm(0.0018, 20) == ["m_joint"]
    assert arm(0.0022, 20) == []
    assert arm(0, 1) == ["m_joint"]
    assert arm(0, 0) == []


def test_a_slide_lengthens_the_lever_by_its_travel() -> None:
    text = link("base") + link("a") + link("b", inertial(2, (1, 1, 1)))
    slide = swinging("b", "a", "1", "0.5 0 0").replace("revolute", "prismatic")
    text += swinging("a", "base", "1")
    assert maximum_loads(tree(text + slide))["a_joint"] == pytest.approx(2 * 9.81 * 3.5)
    free = slide.replace('<limit lower="-3" upper="3" effort="1" velocity="1"/>', "")
    assert maximum_loads(tree(text + free))["a_joint"] == pytest.approx(2 * 9.81 * 0.5)


def test_it_takes_linear_time() -> None:
    def lines(number: int) -> int:
        row = link("l0") + "".join(
            link(f"l{n + 1}", inertial(1, (1, 1, 1))) + swinging(f"l{n + 1}", f"l{n}", "1", "1 0 0")
            for n in range(number)
        )
        deep = tree(row)
        assert len(overloadable_joints(deep)) == number - 1  # the last one has no lever
        return executed_lines(lambda: overloadable_joints(deep))

    assert lines(1000) < 110 * lines(10)


@needs_corpus
@pytest.mark.parametrize(
    "path",
    [
        "anymal_c_simple_description/urdf/anymal.urdf",
        "nao_robot/nao_description/urdf/naoV50_generated_urdf/nao.urdf",
        "gazebo_ros2_control/gazebo_ros2_control_demos/urdf/test_gripper_mimic_joint_effort.xacro.urdf",
    ],
)
def test_no_pose_of_a_real_robot_asks_for_more(path: str) -> None:
    pytest.importorskip("pinocchio")
    from urdfkit.physics.dynamics.statics import statics

    robot = read(CORPUS / path)
    bound = maximum_loads(robot.tree)
    found = statics(robot.dynamics, samples=200)
    assert found.loads
    for load in found.loads:
        assert load.worst <= bound[load.joint] * (1 + 1e-9) + 1e-9


def test_of_a_model_of_our_own() -> None:
    arm = read(ARM)
    most = 9.81 * (1.5 * 0.15 + 0.7 * (0.36 + 0.125))
    assert maximum_loads(arm.tree)["shoulder"] == pytest.approx(most)
    assert overloadable_joints(arm.tree) == []
