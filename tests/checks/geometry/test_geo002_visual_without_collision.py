from __future__ import annotations

import pytest

from tests.conftest import MODELS
from tests.massive import BALL, joint, link, shape
from tests.reported import messages, places
from urdfkit.lint import engine
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity
from urdfkit.text.source import Source

SEEN, TOUCHED = shape("visual", BALL), shape("collision", BALL)
BASE = link("base", SEEN, TOUCHED)


def test_each_link_at_its_first_visual() -> None:
    robot = BASE + link("mast", SEEN, SEEN) + joint("base", "mast")
    assert messages("GEO002", robot) == ["link 'mast' has a visual and no collision"]
    assert places("GEO002", robot) == [(3, "<visual>")]


def test_a_robot_to_look_at_is_one_finding() -> None:
    robot = link("base", SEEN) + link("frame") + link("mast", SEEN) + joint("base", "mast")
    assert messages("GEO002", robot) == ["none of the 2 links with a visual has a collision"]
    assert places("GEO002", robot) == [(1, '<robot name="example">')]


def test_what_is_all_right() -> None:
    assert messages("GEO002", BASE + link("frame") + joint("base", "frame")) == []
    assert messages("GEO002", BASE + link("bump", TOUCHED) + joint("base", "bump")) == []


@pytest.mark.parametrize(
    ("target", "severity"), [("classic-ros1", Severity.INFO), ("moveit", Severity.WARNING)]
)
def test_who_suffers(target: str, severity: Severity) -> None:
    robot = BASE + link("mast", SEEN) + joint("base", "mast")
    source = Source("robot.urdf", whole_robot(robot).encode())
    (found,) = engine.check(source, select=["GEO002"], targets=[target]).diagnostics
    assert found.severity is severity


def test_the_mission_s_model() -> None:
    model = MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
    (found,) = engine.check(model, select=["GEO002"]).diagnostics
    assert (found.message, found.severity) == (
        "link 'base_footprint' has a visual and no collision",
        Severity.INFO,
    )
    assert (found.span.line, found.span.text) == (25, "<visual>")
