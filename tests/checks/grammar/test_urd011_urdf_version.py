import pytest

from tests.naming import naming
from tests.reported import messages, places, reported
from urdfkit.text.diagnostic import Severity

ROBOT = '<robot name="r" version="{}"><link name="a"><visual>{}</visual></link></robot>'
SPHERE = '<origin xyz="0 0 0"/><geometry><sphere radius="1"/></geometry>'


@pytest.mark.parametrize("version", ["1", "2.0", "1.3", "foo", "", "1.0.0", "-1.0"])
def test_versions_that_urdfdom_rejects(version: str) -> None:
    robot = ROBOT.format(version, SPHERE)
    assert messages("URD011", robot) == [naming(version, "1.0, 1.1, 1.2")]
    assert places("URD011", robot) == [(1, version)]


@pytest.mark.parametrize("version", ["1.0", "01.00"])
def test_versions_that_every_parser_reads(version: str) -> None:
    assert reported("URD011", ROBOT.format(version, SPHERE)) == []


@pytest.mark.parametrize("version", ["1.1", "1.2"])
def test_versions_that_older_parsers_reject(version: str) -> None:
    robot = f'<robot name="r" version="{version}"><link name="a"/></robot>'
    (found,) = reported("URD011", robot)
    assert found.severity is Severity.WARNING
    assert found.message == naming(version, "rejected")
    assert places("URD011", robot) == [(1, version)]


CAPSULE = '<geometry><capsule radius="1" length="1"/></geometry>'
TURNED = '<origin quat_xyzw="0 0 0 1"/><geometry><sphere radius="1"/></geometry>'
FEATURES = '<robot name="r"{}>\n<link name="a"><visual>{}</visual></link></robot>'


@pytest.mark.parametrize("version", ["", ' version="1.0"'])
def test_features_of_1_1_in_1_0(version: str) -> None:
    assert messages("URD011", FEATURES.format(version, CAPSULE)) == [
        naming("a", "<capsule>", "1.1", "1.0")
    ]
    assert messages("URD011", FEATURES.format(version, TURNED)) == [
        naming("a", "quat_xyzw", "1.1", "1.0")
    ]
    assert places("URD011", FEATURES.format(version, TURNED)) == [(2, "0 0 0 1")]


@pytest.mark.parametrize(
    ("ends", "help"),
    [
        ('length="1"', naming("1.0", '<robot version="1.1">')),
        ('sp="0 0 0" ep="0 0 1"', naming("spheres")),
    ],
)
def test_a_capsule_of_another_format_is_none_in_any_version(ends: str, help: str) -> None:
    """rby1-sdk's capsules have the start point and the end point of their axis."""
    (found,) = reported("URD011", FEATURES.format("", CAPSULE.replace('length="1"', ends)))
    assert found.help == help


@pytest.mark.parametrize("version", ["1.1", "1.2"])
@pytest.mark.parametrize("content", [CAPSULE, TURNED])
def test_with_the_version_they_are_read(version: str, content: str) -> None:
    robot = FEATURES.format(f' version="{version}"', content)
    assert [found.severity for found in reported("URD011", robot)] == [Severity.WARNING]
    assert [reported(code, robot) for code in ("URD005", "URD004")] == [[], []]


def test_a_quaternion_that_is_read_has_four_numbers() -> None:
    robot = FEATURES.format(' version="1.1"', TURNED.replace("0 0 0 1", "0 0 1"))
    assert messages("URD005", robot) == [naming("a", "quat_xyzw", "<origin>", "3", "4")]


NEW = FEATURES.format(' version="1.1"', TURNED)
BOTH = NEW.replace("<origin", '<origin rpy="0 0 1"')


def of_quaternions(robot: str, *targets: str) -> list[str]:
    return [found.message for found in reported("URD011", robot, targets=targets)][1:]


def test_programs_that_ignore_quaternions() -> None:
    assert of_quaternions(NEW) == of_quaternions(NEW, "pinocchio") == []
    assert of_quaternions(NEW, "ros2", "mujoco", "drake") == [
        naming("a", "quat_xyzw", "<origin>", "ignored", "Drake", "MuJoCo")
    ]
    turned = NEW.replace("0 0 0 1", "0 1 0 1")
    (_, found) = reported("URD011", turned, targets=("mujoco",))
    assert found.help == naming('rpy="0 1.5708 0"', "parser")


def test_an_origin_with_both_rotations() -> None:
    assert of_quaternions(BOTH) == [naming("a", "quat_xyzw", "<origin>", "urdfdom", "rejects")]
    assert of_quaternions(BOTH, "mujoco") == []
    assert messages("URD011", BOTH.replace('"1.1"', '"1.0"')) == [
        naming("a", "quat_xyzw", "1.1", "1.0")
    ]
