"""Robots that are dropped."""

import pytest

pytest.importorskip("mujoco")

from tests.own_robots import own_robots
from tests.simulated import codes, simulated
from urdfkit.checks.dynamics.dyn004_tips_over import BAD as TIPS_OVER
from urdfkit.checks.simulation.sim003_does_not_land import BAD


def test_a_robot_that_sinks() -> None:
    (found,) = simulated(BAD)
    assert found.code == "SIM003"
    assert "'left' sinks" in found.message
    assert "by 30" in found.message
    assert found.span.text == "<collision>"


def test_a_robot_that_tips_over_is_left_to_the_rule_about_it() -> None:
    assert codes(TIPS_OVER, "SIM", "DYN004") == ["DYN004"]


@own_robots
def test_sound_robots(path) -> None:
    import urdfkit
    from urdfkit.lint.options import Options

    report = urdfkit.check(path, select=["SIM"], options=Options(simulate=urdfkit.simulate))
    assert report.diagnostics == ()
