from __future__ import annotations

import pytest

from tests.massive import inertial, joint, link
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

TENSOR = (1e-10, 1e-10, 1e-10)
BASE = link("base", inertial(2, (1, 1, 1)))


def tip(mass: float, kind: str = "prismatic") -> str:
    return BASE + link("tip", inertial(mass, TENSOR)) + joint("base", "tip", kind)


def test_a_moving_link() -> None:
    assert messages("INE017", tip(1e-10)) == [
        (
            "link 'tip' weighs 1e-10 kg and is moved by the prismatic joint 'tip_joint'; up to "
            "1e-06 kg older Gazebo leaves it out"
        )
    ]
    assert places("INE017", tip(1e-10)) == [(4, "1e-10")]


def test_the_largest_that_is_none() -> None:
    assert len(messages("INE017", tip(1e-6))) == 1


def test_a_mass_without_moments() -> None:
    light = link("tip", '<inertial><mass value="1e-10"/></inertial>')
    assert len(messages("INE017", BASE + light + joint("base", "tip", "prismatic"))) == 1


@pytest.mark.parametrize(
    "robot",
    [
        tip(1.1e-6),
        tip(1e-10, "fixed"),
        tip(0),
        tip(1e-10) + link("pad", inertial(0.01, (1, 1, 1))) + joint("tip", "pad"),
    ],
)
def test_what_is_all_right_or_another_rule_s(robot: str) -> None:
    assert messages("INE017", robot) == []


@pytest.mark.parametrize(
    ("target", "severity"),
    [
        ("classic-ros1", Severity.WARNING),
        ("gz-fortress", Severity.WARNING),
        ("gz-harmonic", Severity.INFO),
        ("ros2", Severity.INFO),
    ],
)
def test_who_suffers(target: str, severity: Severity) -> None:
    source = Source("robot.urdf", whole_robot(tip(1e-10)).encode())
    (found,) = engine.check(source, select=["INE017"], targets=[target]).diagnostics
    assert found.severity is severity
