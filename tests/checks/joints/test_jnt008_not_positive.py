import pytest

from tests.jointed import joint, limit, mimic, robot
from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

UNITS = [
    ("revolute", "effort", "N·m"),
    ("continuous", "effort", "N·m"),
    ("prismatic", "effort", "N"),
    ("revolute", "velocity", "rad/s"),
    ("continuous", "velocity", "rad/s"),
    ("prismatic", "velocity", "m/s"),
]


def limited(key: str, value: str) -> str:
    return limit("-1", "1", **{key: value})


@pytest.mark.parametrize(("kind", "key", "unit"), UNITS)
@pytest.mark.parametrize(("value", "severity"), [("0", Severity.WARNING), ("-0.5", Severity.ERROR)])
def test_one_joint(kind: str, key: str, unit: str, value: str, severity: Severity) -> None:
    text = robot(joint("a", kind, limited(key, value)), joint("b", "continuous"))
    (found,) = reported("JNT008", text)
    assert found.message == naming("a", key, f"{value} {unit}", *(["0"] if value < "0" else []))
    assert found.severity is severity
    assert places("JNT008", text) == [(4, value)]


def test_all_joints_of_a_robot_are_one_finding() -> None:
    text = robot(*(joint(f"j{n}", "revolute", limited("effort", "0")) for n in range(60)))
    (found,) = reported("JNT008", text)
    assert found.message == naming("j0", "j1", "58", "effort", "0 N·m")
    lines = [(other.span.line, other.message) for other in found.related]
    assert lines[:2] == [(6, "joint 'j1'"), (8, "joint 'j2'")]
    assert len(lines) == 20, "not all are listed"


def test_effort_and_velocity_and_both_signs_are_apart() -> None:
    limits = [limit("-1", "1", *pair) for pair in (("0", "0"), ("-1", "-2"))]
    text = robot(*(joint(f"j{n}", "revolute", one) for n, one in enumerate(limits)))
    assert places("JNT008", text) == [(4, "0"), (4, "0"), (6, "-1"), (6, "-2")]


def test_a_macro_is_one_place() -> None:
    macro = joint("${name}", "revolute", limited("effort", "0"))
    text = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>'
        f'<xacro:macro name="arm" params="name">{macro}</xacro:macro>'
        '<xacro:arm name="a"/><xacro:arm name="b"/></robot>'
    )
    (found,) = reported("JNT008", text, "robot.xacro")
    assert found.message == naming("a", "b", "effort", "0 N·m")
    assert found.related == ()


@pytest.mark.parametrize("key", ["effort", "velocity"])
@pytest.mark.parametrize(
    ("kind", "content", "value"),
    [
        ("revolute", "", "5"),
        ("revolute", "", "x"),  # URD005
        ("fixed", "", "0"),
        ("fixed", "", "-1"),
        ("revolute", mimic("b"), "0"),  # no motor of its own
    ],
)
def test_no_finding(key: str, kind: str, content: str, value: str) -> None:
    text = robot(
        joint("a", kind, limited(key, value) + content), joint("b", "revolute", limit("-1", "1"))
    )
    assert reported("JNT008", text) == []


@pytest.mark.parametrize("ends", [("0", "0"), ("0.3", "0.3")])
@pytest.mark.parametrize("key", ["effort", "velocity"])
def test_a_joint_that_cannot_move_needs_none(key: str, ends: tuple[str, str]) -> None:
    text = robot(joint("a", "revolute", limit(*ends, **{key: "0"})))
    assert messages("JNT008", text) == []
    assert len(messages("JNT003", text)) == 1


TRANSMISSION = '<transmission name="t"><joint name="{}"/></transmission>'
CONTROL = (
    '<ros2_control name="c" type="system"><joint name="{}">'
    '<command_interface name="position"/></joint>'
    '<joint name="a"><state_interface name="position"/></joint></ros2_control>'
)


@pytest.mark.parametrize(
    ("name", "kind", "effort", "velocity"),
    [
        ("caster_swivel", "continuous", 0, 1),  # Trossen's mobile_ai
        ("wheel_roller_3", "continuous", 0, 1),
        ("wheel", "continuous", 1, 1),
        ("caster_lift", "prismatic", 1, 1),
    ],
)
def test_a_caster_has_no_motor(name: str, kind: str, effort: int, velocity: int) -> None:
    for key, count in (("effort", effort), ("velocity", velocity)):
        text = robot(joint(name, kind, limited(key, "0")))
        assert len(messages("JNT008", text)) == count


@pytest.mark.parametrize("key", ["effort", "velocity"])
@pytest.mark.parametrize("drive", [TRANSMISSION, CONTROL])
def test_a_joint_without_a_drive_is_passive_where_others_have_one(key: str, drive: str) -> None:
    pair = robot(joint("a", "continuous", limited(key, "0")), joint("b", "continuous"))
    assert len(reported("JNT008", pair)) == 1
    assert reported("JNT008", pair + drive.format("b")) == []
    assert len(reported("JNT008", pair + drive.format("a"))) == 1


TRANSMISSION = (
    '<transmission name="t"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="a"><hardwareInterface>hardware_interface/EffortJointInterface'
    "</hardwareInterface></joint>"
    '<actuator name="m"><mechanicalReduction>1</mechanicalReduction></actuator></transmission>'
)


@pytest.mark.parametrize(
    ("targets", "more", "severity"),
    [
        (("ros1", "classic-ros1"), "", Severity.WARNING),
        (("gz-harmonic",), "", Severity.WARNING),
        (("ros1", "classic-ros1"), TRANSMISSION, Severity.ERROR),
        (("classic-ros1", "moveit"), "", Severity.ERROR),
        (("ros1",), "", Severity.ERROR),
    ],
)
@pytest.mark.parametrize("key", ["effort", "velocity"])
def test_gazebo_reads_a_negative_limit_as_none(
    key: str, targets: tuple[str, ...], more: str, severity: Severity
) -> None:
    """As the wheels of a car that a plugin of Gazebo drives."""
    text = robot(joint("a", "continuous", limited(key, "-1")), more)
    (found,) = reported("JNT008", text, targets=targets)
    assert found.severity is severity
    assert found.message.endswith("below 0")
