from __future__ import annotations

import pytest

from tests.massive import inertial, joint, link
from tests.reported import messages, places, reported
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

BASE = link("base", inertial(2, (1, 1, 1)))
THIN = (0.02, 0.02, 0)


def rod(moments: tuple[float, ...], kind: str = "revolute") -> str:
    return BASE + link("rod", inertial(0.3, moments)) + joint("base", "rod", kind)


def test_a_rod_without_thickness() -> None:
    assert messages("INE018", rod(THIN)) == [
        (
            "link 'rod', moved by the revolute joint 'rod_joint', has principal moments of inertia "
            "of 0, 0.02 and 0.02 kg m^2: nothing about one axis"
        )
    ]
    assert [line for line, _ in places("INE018", rod(THIN))] == [5]


@pytest.mark.parametrize(
    "robot",
    [
        rod((0.02, 0.02, 1e-9)),
        rod(THIN, "fixed"),
        rod(THIN) + link("ball", inertial(1, (1, 1, 1))) + joint("rod", "ball"),
        rod((0.02, 0, 0)),  # INE003
        rod((0, 0, 0)),  # INE005
    ],
)
def test_what_is_all_right_or_another_rule_s(robot: str) -> None:
    assert messages("INE018", robot) == []


def test_two_rods_across_each_other_are_thin_about_no_axis() -> None:
    other = link("bar", inertial(0.3, (0, 0.02, 0.02))) + joint("rod", "bar")
    assert messages("INE018", rod(THIN) + other) == []


def test_a_whole_export_is_one_finding() -> None:
    robot = rod(THIN)
    for above, name, mass in (("rod", "a", 3), ("a", "b", 1)):
        robot += link(name, inertial(mass, (0.03, 0.03, 0))) + joint(above, name, "revolute")
    (found,) = reported("INE018", robot)
    assert found.message.startswith("link 'a'")
    assert found.message.endswith("(2 more links likewise)")
    assert len(found.related) == 2


@pytest.mark.parametrize(
    ("targets", "severity"), [((), Severity.WARNING), (("mujoco",), Severity.ERROR)]
)
def test_who_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    source = Source("robot.urdf", whole_robot(rod(THIN)).encode())
    (found,) = engine.check(source, select=["INE018"], targets=targets).diagnostics
    assert found.severity is severity
