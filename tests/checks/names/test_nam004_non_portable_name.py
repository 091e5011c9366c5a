import pytest

from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("base link", "white space in"),
        ("base_link ", "white space at"),
        (" base_link", "white space at"),
        ("arm&#9;1", "white space in"),
        ("arm::1", "'::' in"),
        ("/base", "tf2 rejects"),
    ],
)
def test_the_character(name: str, reason: str) -> None:
    (found,) = reported("NAM004", f'<link name="{name}"/>')
    assert found.message.startswith(f"link '{name.replace('&#9;', chr(9))}': {reason}")
    assert found.severity is Severity.WARNING
    assert places("NAM004", f'<link name="{name}"/>') == [(2, name)]


@pytest.mark.parametrize(
    "name", ["base_link", "wrist_3-flange", "arm.1", "robot/base", "\u8155", "\u0662", "", "${a b}"]
)
def test_names_that_all_programs_accept_or_other_rules_report(name: str) -> None:
    assert reported("NAM004", f'<link name="{name}"/>') == []


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("revolute", 1), ("continuous", 1)])
@pytest.mark.parametrize("name", ["ur5e/elbow", "/elbow"])
def test_a_slash_in_the_name_of_a_joint_that_moves(name: str, kind: str, count: int) -> None:
    robot = f'<link name="a"/><joint name="{name}" type="{kind}"/>'
    assert len(messages("NAM004", robot)) == count


def test_white_space_in_the_name_of_a_fixed_joint_is_an_info() -> None:
    (found,) = reported("NAM004", '<link name="a"/><joint name="a b" type="fixed"/>')
    assert found.severity is Severity.INFO


BODY = '<visual><geometry><sphere radius="1"/></geometry></visual>'
JOINT = '<joint name="{}" type="fixed"><parent link="{}"/><child link="{}"/></joint>'
WORLD = f'<link name="world">{BODY}</link>'


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        (WORLD, "link 'world': Gazebo reads"),
        (
            '<link name="a"/><link name="world"/>' + JOINT.format("j", "a", "world"),
            "link 'world': Gazebo and MuJoCo read",
        ),
        (
            '<link name="a"/><link name="b"/>' + JOINT.format("world", "a", "b"),
            "joint 'world': the name is",
        ),
        ('<link name="__a__"/>', "link '__a__': names in double"),
    ],
)
def test_reserved_names(robot: str, message: str) -> None:
    (found,) = messages("NAM004", robot)
    assert found.startswith(message)


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="world"/><link name="b"/>' + JOINT.format("fix", "world", "b"),
        '<link name="world_link"/>',
        '<link name="__a"/>',
        '<link name="____"/>',
    ],
)
def test_an_empty_world_that_fixes_the_robot_is_right(robot: str) -> None:
    assert reported("NAM004", robot) == []


def test_links_and_joints_that_begin_with_a_digit() -> None:
    robot = '<link name="2nd"/><link name="arm2"/><joint name="1_2" type="fixed"/>'
    assert places("NAM004", robot) == [(2, "2nd"), (2, "1_2")]
    links = "".join(f'<link name="{digit}a"/>' for digit in "0123456789")
    assert len(messages("NAM004", links)) == 10


@pytest.mark.parametrize(
    ("robot", "targets", "severity"),
    [
        (WORLD, (), Severity.INFO),
        (WORLD, ("ros2",), Severity.INFO),
        (WORLD, ("gz-harmonic",), Severity.WARNING),
        (WORLD, ("mujoco",), Severity.WARNING),
        ('<link name="2nd"/>', (), Severity.INFO),
        ('<link name="2nd"/>', ("isaac",), Severity.WARNING),
    ],
)
def test_the_severity_is_that_of_the_target(
    robot: str, targets: tuple[str, ...], severity: Severity
) -> None:
    (found,) = reported("NAM004", robot, targets=targets)
    assert found.severity is severity
