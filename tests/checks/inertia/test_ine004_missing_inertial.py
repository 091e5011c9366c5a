from __future__ import annotations

import pytest

from tests.conftest import MODELS
from tests.massive import BALL, inertial, joint, link, shape
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Diagnostic, Severity
from urdfkit.text.source import Source

HEAVY = inertial(1, (0.1, 0.1, 0.1))
SEEN = shape("visual", BALL)
BASE = link("base", HEAVY)


def reported(text: str, *targets: str) -> list[Diagnostic]:
    source = Source("robot.urdf", whole_robot(text).encode())
    return list(engine.check(source, select=["INE004"], targets=targets).diagnostics)


@pytest.mark.parametrize(
    ("targets", "severity"),
    [
        ((), Severity.INFO),
        (("ros2", "moveit"), Severity.INFO),
        (("classic-ros1",), Severity.ERROR),
        (("ros2", "gz-harmonic"), Severity.ERROR),
        (("mujoco",), Severity.ERROR),
    ],
)
def test_who_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    robot = BASE + link("arm", SEEN) + joint("base", "arm", "continuous")
    (found,) = reported(robot, *targets)
    assert found.severity is severity
    assert found.message == (
        "link 'arm' is moved by the continuous joint 'arm_joint' and has no mass: Gazebo leaves "
        "it out"
    )
    assert (found.span.line, found.span.text) == (4, '<link name="arm">')


def test_what_goes_with_it_is_named() -> None:
    robot = BASE + link("arm", SEEN) + joint("base", "arm", "revolute") + link("frame")
    robot += joint("arm", "frame")
    for number in range(6):
        above = f"l{number - 1}" if number else "arm"
        robot += link(f"l{number}", HEAVY) + joint(above, f"l{number}", "prismatic")
    (found,) = reported(robot, "gz-jetty")
    assert found.message.endswith("leaves it out and with it 'l0', 'l1', 'l2' and 3 more")


@pytest.mark.parametrize(
    "robot",
    [
        BASE + link("arm", SEEN) + joint("base", "arm"),  # becomes a part of the base
        BASE
        + link("arm", SEEN)
        + joint("base", "arm", "continuous")
        + link("hand", HEAVY)
        + joint("arm", "hand"),  # what is fixed to it has the mass
        BASE + link("tip") + joint("base", "tip", "continuous"),  # a frame without a shape
        link("dummy") + BASE + joint("dummy", "base"),  # the usual remedy for KDL
        link("world") + BASE + joint("world", "base", "floating"),
        link("base", SEEN) + link("arm", SEEN) + joint("base", "arm", "revolute"),  # INE019
        BASE + link("arm", inertial(0, (1, 1, 1)), SEEN) + joint("base", "arm", "revolute"),
    ],
)
def test_what_is_all_right_or_another_rule_s(robot: str) -> None:
    assert reported(robot, "classic-ros1") == []


def test_a_root_without_mass_loses_the_robot_in_gazebo() -> None:
    robot = link("base", SEEN) + link("arm", HEAVY) + joint("base", "arm", "continuous")
    assert reported(robot) == reported(robot, "mujoco") == []
    (found,) = reported(robot, "gz-fortress")
    assert found.message == (
        "link 'base' is the root and has no mass: Gazebo leaves it out and with it 'arm'"
    )


def test_a_fixed_joint_that_gazebo_keeps_needs_a_mass() -> None:
    robot = BASE + link("arm", SEEN) + joint("base", "arm")
    kept = "<gazebo reference='arm_joint'><preserveFixedJoint>true</preserveFixedJoint></gazebo>"
    assert reported(robot) == []
    assert len(reported(robot + kept)) == 1


def test_the_mission_s_model_has_a_massless_root_and_nothing_is_said() -> None:
    model = MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
    assert engine.check(model, select=["INE004"]).diagnostics == ()
