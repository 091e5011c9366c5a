from __future__ import annotations

import pytest

from tests.massive import BALL, inertial, joint, link, shape
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

SEEN = shape("visual", BALL)
ARM = link("base", SEEN) + link("arm", SEEN) + joint("base", "arm", "revolute")


def test_once_for_the_whole_robot() -> None:
    assert messages("INE019", ARM) == ["none of the 2 links has a mass"]
    assert places("INE019", ARM) == [(1, '<robot name="example">')]
    assert messages("INE019", link("base", SEEN)) == ["the link has no mass"]
    assert messages("INE004", ARM) == []


@pytest.mark.parametrize("mass", [0.0, 1.0])
def test_a_mass_of_nothing_is_none(mass: float) -> None:
    robot = ARM + link("hand", inertial(mass, (1, 1, 1))) + joint("arm", "hand")
    assert len(messages("INE019", robot)) == (mass == 0)


def test_a_macro_library_is_no_robot() -> None:
    assert messages("INE019", '<robot name="parts"/>') == []


@pytest.mark.parametrize(
    ("targets", "severity"),
    [((), Severity.INFO), (("ros1", "moveit"), Severity.INFO), (("gz-jetty",), Severity.ERROR)],
)
def test_who_suffers(targets: tuple[str, ...], severity: Severity) -> None:
    source = Source("robot.urdf", whole_robot(ARM).encode())
    (found,) = engine.check(source, select=["INE019"], targets=targets).diagnostics
    assert found.severity is severity
