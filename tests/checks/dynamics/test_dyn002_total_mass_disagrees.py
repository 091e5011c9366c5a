from __future__ import annotations

import pytest

from tests.conftest import MODELS
from tests.massive import inertial, link
from tests.reported import reported
from urdfkit.lint import engine

pytest.importorskip("pinocchio")
FOR = ("pinocchio",)


def test_a_place_that_cannot_be_read_drops_the_mass() -> None:
    text = link("a", inertial(3, (1, 1, 1), xyz="0 0.5"))
    (found,) = reported("DYN002", text, targets=FOR)
    assert found.message == (
        "the robot weighs 0 kg to Pinocchio, and 3 kg as its links state: "
        "Parser found 2 elements but 3 expected while parsing vector [0 0.5]"
    )


def test_a_mass_that_nobody_can_read_is_none_to_both() -> None:
    text = link("a", inertial(3, (1, 1, 1)).replace("3", "3kg", 1))
    assert reported("DYN002", text, targets=FOR) == []


def test_a_refusal_is_told_by_another_rule() -> None:
    bad = link("a", inertial(3, (1, 1, 1), xyz="0 0.5"))
    assert reported("DYN002", bad + link("b"), targets=FOR) == []


def test_the_mission_s_model() -> None:
    model = MODELS / "gazebo_pkg" / "urdf" / "waking_robot_new.xacro"
    report = engine.check(model, select=["DYN"], targets=FOR)
    assert (report.diagnostics, report.skipped, report.crashed) == ((), (), ())
