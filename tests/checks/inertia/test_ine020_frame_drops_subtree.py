from __future__ import annotations

import pytest

from tests.massive import inertial, joint, link
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

HEAVY = inertial(1, (1, 1, 1))
ROBOT = (
    link("base", HEAVY)
    + link("plate")
    + link("arm", HEAVY)
    + joint("base", "plate")
    + joint("plate", "arm", "continuous")
)


def test_a_joint_on_a_massless_plate() -> None:
    assert messages("INE020", ROBOT) == [
        (
            "joint 'arm_joint' hangs on link 'plate', which has no mass and is fixed to another "
            "link: older Gazebo leaves out 'arm' and what is on it"
        )
    ]
    assert places("INE020", ROBOT) == [(8, '<joint name="arm_joint" type="continuous">')]


@pytest.mark.parametrize(
    "robot",
    [
        ROBOT.replace(link("plate"), link("plate", HEAVY)),
        ROBOT.replace('<parent link="plate"/>', '<parent link="base"/>'),
        ROBOT + link("bolt", HEAVY) + joint("plate", "bolt"),  # which is merged into the plate
        ROBOT.replace('"base"', '"world"').replace(HEAVY, "", 1),  # a joint that Gazebo keeps
        link("plate")
        + link("base", HEAVY)
        + joint("plate", "base")
        + link("arm", HEAVY)
        + joint("plate", "arm", "continuous"),  # the root
    ],
)
def test_what_older_gazebo_keeps(robot: str) -> None:
    assert messages("INE020", robot) == []


@pytest.mark.parametrize(
    ("target", "severity"),
    [
        ("classic-ros1", Severity.WARNING),
        ("gz-fortress", Severity.WARNING),
        ("gz-harmonic", Severity.INFO),
    ],
)
def test_who_suffers(target: str, severity: Severity) -> None:
    source = Source("robot.urdf", whole_robot(ROBOT).encode())
    (found,) = engine.check(source, select=["INE020"], targets=[target]).diagnostics
    assert found.severity is severity
