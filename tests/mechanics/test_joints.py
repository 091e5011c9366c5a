"""What the rules about joints share."""

from __future__ import annotations

import pytest

from tests.jointed import joint, limit, mimic, robot
from urdfkit.examples import whole_robot
from urdfkit.mechanics import joints
from urdfkit.model import Joint, RobotModel
from urdfkit.reading import read_xml
from urdfkit.source import Source


def model(text: str) -> RobotModel:
    document, problems = read_xml(Source("robot.urdf", whole_robot(text).encode()))
    assert document is not None
    assert problems == []
    return RobotModel(document)


def one(kind: str, content: str) -> Joint:
    return model(robot(joint("j", kind, content))).joints[0]


@pytest.mark.parametrize(
    ("kind", "content", "bounds"),
    [
        ("revolute", limit("-1", "2"), (-1.0, 2.0)),
        ("prismatic", '<limit upper="2"/>', (0.0, 2.0)),
        ("revolute", "<limit/>", (0.0, 0.0)),
        ("revolute", limit("-1", "two"), None),
        ("revolute", "", None),
        ("continuous", limit("-1", "2"), None),
        ("fixed", limit("-1", "2"), None),
    ],
)
def test_bounds(kind: str, content: str, bounds: tuple[float, float] | None) -> None:
    assert joints.bounds(one(kind, content)) == bounds


@pytest.mark.parametrize(
    ("content", "bounds"),
    [
        ('<safety_controller soft_lower_limit="-1" soft_upper_limit="2"/>', (-1.0, 2.0)),
        ('<safety_controller soft_upper_limit="2"/>', (0.0, 2.0)),
        ("<safety_controller/>", (0.0, 0.0)),
        ('<safety_controller soft_lower_limit=""/>', None),
        ("", None),
    ],
)
def test_soft_bounds(content: str, bounds: tuple[float, float] | None) -> None:
    assert joints.soft_bounds(one("continuous", content)) == bounds


def test_units() -> None:
    assert (joints.unit(one("revolute", "")), joints.effort_unit(one("revolute", ""))) == (
        "rad",
        "N m",
    )
    assert (joints.unit(one("prismatic", "")), joints.effort_unit(one("prismatic", ""))) == (
        "m",
        "N",
    )


@pytest.mark.parametrize(
    ("count", "text"),
    [
        (1, "joint 'j0'"),
        (2, "joints 'j0' and 'j1'"),
        (3, "joints 'j0', 'j1' and 1 more"),
        (9, "joints 'j0', 'j1' and 7 more"),
    ],
)
def test_several(count: int, text: str) -> None:
    robots = model(robot(*(joint(f"j{number}", "fixed") for number in range(count))))
    assert joints.several(robots.joints) == text


def test_driven() -> None:
    text = robot(joint("a", "continuous"))
    assert joints.driven(model(text)) == frozenset()
    transmission = '<transmission name="t"><joint name="a"/><actuator name="m"/></transmission>'
    control = (
        '<ros2_control name="c" type="system"><joint name="b"><command_interface name="effort"/>'
        '</joint><joint name="c"><state_interface name="position"/></joint></ros2_control>'
    )
    assert joints.driven(model(text + transmission + control)) == {"a", "b"}


def zero(of: str, text: str) -> str:
    """A limit in which effort or velocity is as given."""
    return limit("-1", "1", **{of: text})


def limited(of: str, text: str) -> list[str]:
    """The joints whose effort or velocity is limited to zero."""
    return [found.name for found, _ in joints.limited_to_zero(model(text), of)]


@pytest.mark.parametrize("of", ["effort", "velocity"])
@pytest.mark.parametrize(
    ("kind", "text", "rest", "count"),
    [
        ("revolute", "0", "", 1),
        ("prismatic", "0.0", "", 1),
        ("continuous", "0", "", 1),
        ("revolute", "5", "", 0),
        ("revolute", "-1", "", 0),  # JNT028
        ("revolute", "x", "", 0),  # URD005
        ("fixed", "0", "", 0),
        ("revolute", "0", mimic("b"), 0),  # nothing drives it
    ],
)
def test_limited_to_zero(of: str, kind: str, text: str, rest: str, count: int) -> None:
    other = "velocity" if of == "effort" else "effort"
    joined = joint("a", kind, zero(of, text) + rest), joint("b", "revolute", zero(other, "0"))
    assert limited(of, robot(*joined)) == ["a"] * count
    assert limited(of, robot(joint("a", "continuous"))) == []


TRANSMISSION = '<transmission name="t"><joint name="{}"/></transmission>'
CONTROL = (
    '<ros2_control name="c" type="system"><joint name="{}">'
    '<command_interface name="position"/></joint>'
    '<joint name="a"><state_interface name="position"/></joint></ros2_control>'
)


@pytest.mark.parametrize("of", ["effort", "velocity"])
@pytest.mark.parametrize("drive", [TRANSMISSION, CONTROL])
def test_a_joint_that_nothing_drives_is_passive_where_others_are_driven(
    of: str, drive: str
) -> None:
    text = robot(joint("a", "revolute", zero(of, "0")), joint("b", "revolute", zero(of, "5")))
    assert limited(of, text + drive.format("b")) == []
    assert limited(of, text + drive.format("a")) == ["a"]
