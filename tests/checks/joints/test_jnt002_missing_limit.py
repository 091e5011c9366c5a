from pathlib import Path

import pytest

from tests.conftest import MODELS
from tests.jointed import joint, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from tests.urdfdom import needs_check_urdf, urdfdom_reads
from urdfkit.lint import engine
from urdfkit.text.diagnostic import Severity

CASES = {
    ("revolute", ""): [naming("j", "revolute", "<limit>")],
    ("prismatic", ""): [naming("j", "prismatic", "<limit>")],
    ("continuous", ""): [],
    ("fixed", ""): [],
    ("floating", ""): [],
    ("planar", ""): [],
    ("revolute", "<limit/>"): [naming("j", "<limit>", "effort", "velocity")],
    ("revolute", '<limit lower="0" upper="1" effort="1"/>'): [naming("j", "<limit>", "velocity")],
    ("continuous", '<limit velocity="1"/>'): [naming("j", "<limit>", "effort")],
    ("fixed", '<limit velocity="1"/>'): [naming("j", "<limit>", "effort")],
    ("floating", '<limit effort="1"/>'): [naming("j", "<limit>", "velocity")],
    ("revolute", '<limit effort="1" velocity="1"/>'): [],
    ("continuous", '<limit effort="1" velocity="1"/>'): [],
}


@pytest.mark.parametrize(("kind", "content"), CASES)
def test_what_is_missing(kind: str, content: str) -> None:
    assert messages("JNT002", robot(joint("j", kind, content))) == CASES[kind, content]


@needs_check_urdf
@pytest.mark.parametrize(("kind", "content"), CASES)
def test_urdfdom_agrees(kind: str, content: str, tmp_path: Path) -> None:
    assert urdfdom_reads(robot(joint("j", kind, content)), tmp_path) == (CASES[kind, content] == [])


def test_the_place_is_the_limit_or_else_the_joint() -> None:
    assert places("JNT002", robot(joint("j", "fixed", '<limit effort="1"/>'))) == [
        (4, '<limit effort="1"/>')
    ]
    assert places("JNT002", robot(joint("j", "revolute"))) == [
        (4, '<joint name="j" type="revolute">')
    ]


@pytest.mark.parametrize(
    ("kind", "help"),
    [
        (
            "revolute",
            naming("<limit>", "lower", "upper", "effort", "N·m", "velocity", "rad/s"),
        ),
        ("prismatic", naming("<limit>", "lower", "upper", "effort", "velocity", "m/s")),
    ],
)
def test_the_help_has_the_units(kind: str, help: str) -> None:
    assert [found.help for found in reported("JNT002", robot(joint("j", kind)))] == [help]
    short = robot(joint("j", kind, "<limit/>"))
    effort, velocity = ("N·m", "rad/s") if kind == "revolute" else ("N", "m/s")
    units = f"effort in {effort} and velocity in {velocity}"
    assert reported("JNT002", short)[0].help.endswith(units)


LIMIT = '<limit effort="100" velocity="20"/>'


def test_a_wheel_next_to_one_with_limits() -> None:
    text = robot(joint("a", "continuous"), joint("b", "continuous", LIMIT))
    (found,) = reported("JNT002", text)
    assert found.severity is Severity.INFO
    assert found.message == naming("a", "effort", "velocity", "b", "both")
    assert places("JNT002", text) == [(4, '<joint name="a" type="continuous">')]
    assert [other.span.text for other in found.related] == [LIMIT]


@pytest.mark.parametrize(
    "joints",
    [
        [joint("a", "continuous"), joint("b", "continuous")],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", LIMIT)],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", parent="a_link")],
        [joint("a", "continuous", LIMIT), joint("b", "continuous", mimic("a"))],
        [joint("a", "continuous", LIMIT), joint("b", "fixed")],
        [joint("a", "fixed", LIMIT), joint("b", "continuous")],
    ],
)
def test_joints_that_are_not_compared(joints: list[str]) -> None:
    assert reported("JNT002", robot(*joints)) == []


def test_the_wheels_of_the_mission() -> None:
    model = MODELS / "gazebo_pkg/urdf/waking_robot_new.xacro"
    report = engine.check(model, select=["JNT"], ignore=["JNT020", "JNT030"])
    found = [(one.code, one.element, one.severity.value) for one in report.diagnostics]
    assert found == [("JNT002", f"joint/base_to_wheel{number}", "info") for number in (1, 3, 4)]
