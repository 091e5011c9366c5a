"""What the rules about joints share."""

from math import pi

import pytest

from tests.documents import model
from tests.jointed import joint, limit, robot
from urdfkit.robot import joint_limits
from urdfkit.robot.joint import Joint


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
    assert joint_limits.bounds(one(kind, content)) == bounds


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
    assert joint_limits.soft_bounds(one("continuous", content)) == bounds


@pytest.mark.parametrize(
    ("kind", "is_rotational", "is_prismatic", "unit", "effort_unit"),
    [
        ("revolute", True, False, "rad", "N·m"),
        ("continuous", True, False, "rad", "N·m"),
        ("prismatic", False, True, "m", "N"),
    ],
)
def test_single_dof_joints(
    kind: str, is_rotational: bool, is_prismatic: bool, unit: str, effort_unit: str
) -> None:
    joint = one(kind, "")
    assert joint.is_single_dof
    assert (joint.is_rotational, joint.is_prismatic) == (is_rotational, is_prismatic)
    assert (joint.unit, joint.effort_unit) == (unit, effort_unit)


@pytest.mark.parametrize("kind", ["fixed", "planar", "floating", ""])
def test_other_joints(kind: str) -> None:
    joint = one(kind, "")
    assert not joint.is_single_dof
    assert not joint.is_rotational
    assert not joint.is_prismatic


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
    assert joint_limits.several(robots.joints) == text


def test_driven() -> None:
    text = robot(joint("a", "continuous"))
    assert joint_limits.driven(model(text)) == frozenset()
    transmission = '<transmission name="t"><joint name="a"/><actuator name="m"/></transmission>'
    control = (
        '<ros2_control name="c" type="system"><joint name="b"><command_interface name="effort"/>'
        '</joint><joint name="c"><state_interface name="position"/></joint></ros2_control>'
    )
    assert joint_limits.driven(model(text + transmission + control)) == {"a", "b"}


def test_where_a_joint_moves() -> None:
    """Limits, or all there is where they mean nothing; no more than a turn, with 0 if it may."""

    def ends(kind: str, lower: str = "", upper: str = "") -> tuple[float, float]:
        return joint_limits.span(one(kind, limit(lower, upper) if lower else ""))

    assert ends("revolute", "-1", "2") == (-1, 2)
    assert ends("revolute", "0.5", "0.5") == (0.5, 0.5)
    for free in (("revolute",), ("revolute", "1", "-1"), ("continuous",), ("continuous", "0", "1")):
        assert ends(*free) == (-pi, pi)
    assert ends("revolute", "-1e308", "1e308") == (-pi, pi)
    assert ends("revolute", "-1", "9") == (-1, 2 * pi - 1)
    assert ends("revolute", "-9", "1") == (1 - 2 * pi, 1)
    assert ends("revolute", "0", "7") == (0, 2 * pi)
    assert ends("revolute", "100", "110") == (100, 100 + 2 * pi)
    assert ends("prismatic", "-0.1", "0.2") == (-0.1, 0.2)
    assert ends("prismatic", "-1e308", "1e308") == (
        -joint_limits.MAX_TRAVEL,
        joint_limits.MAX_TRAVEL,
    )
    assert ends("prismatic", "2000", "3000") == (joint_limits.MAX_TRAVEL, joint_limits.MAX_TRAVEL)
    for still in (("prismatic",), ("prismatic", "1", "-1"), ("fixed", "1", "2"), ("planar",)):
        assert ends(*still) == (0, 0)


@pytest.mark.parametrize(
    ("lower", "upper", "start"),
    [("-1", "2", 0), ("0", "2", 0), ("-2", "0", 0), ("1", "2", 1.5), ("-2", "-1", -1.5)],
)
def test_where_a_joint_begins(lower: str, upper: str, start: float) -> None:
    for kind in ("revolute", "prismatic"):
        assert joint_limits.start_of(one(kind, limit(lower, upper))) == start
    assert joint_limits.start_of(one("revolute", limit("7", "20"))) == pytest.approx(7 + pi)
