from __future__ import annotations

import pytest

from tests.conftest import MODELS
from tests.jointed import joint, mimic, robot
from tests.reported import messages, places, reported
from urdfkit.lint import engine

LIMIT = '<limit effort="100" velocity="20"/>'


def test_a_wheel_beside_one_with_limits() -> None:
    text = robot(joint("a", "continuous"), joint("b", "continuous", LIMIT))
    assert messages("JNT021", text) == [
        "joint 'a' has no effort and velocity limit; 'b' beside it has 100 N m and 20 rad/s"
    ]
    assert places("JNT021", text) == [(4, '<joint name="a" type="continuous">')]
    assert [other.message for other in reported("JNT021", text)[0].related] == ["the limit of 'b'"]


@pytest.mark.parametrize(
    "joints",
    [
        [joint("a", "continuous"), joint("b", "continuous")],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", LIMIT)],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", parent="a_link")],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", mimic("a"))],
        [joint("a", "continuous", LIMIT), joint("b", "fixed")],
        [joint("a", "revolute", LIMIT), joint("b", "continuous")],
        [joint("a", "continuous", "<limit/>"), joint("b", "continuous")],  # JNT002
    ],
)
def test_no_finding(joints: list[str]) -> None:
    assert reported("JNT021", robot(*joints)) == []


def test_the_wheels_of_the_mission() -> None:
    robot = MODELS / "gazebo_pkg/urdf/waking_robot_new.xacro"
    report = engine.check(robot, select=["JNT"], ignore=["JNT020"])
    found = [(one.code, one.element, one.severity.value) for one in report.diagnostics]
    assert found == [("JNT021", f"joint/base_to_wheel{number}", "info") for number in (1, 3, 4)]
