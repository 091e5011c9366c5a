"""What the rules about Gazebo's tags and plugins say about the mission's own robot, exactly."""

from collections import Counter

import pytest

from tests.conftest import MISSION, SHARED, manifest
from urdfkit.lint import engine, rule_index
from urdfkit.text.diagnostic import Diagnostic
from urdfkit.text.source import Source

FAMILY = [*(code for code in rule_index.codes() if "GAZ001" <= code <= "GAZ034"), "RCT029"]

#: Codes and places whatever the target is.
ALWAYS = [
    ("GAZ016", "<bodyName>"),
    ("GAZ016", "<enableYAxis>"),
    ("GAZ029", '<joint name="base_to_wheel1" type="continuous">'),
    ("GAZ030", "<commandTopic>"),
    ("GAZ030", "<imageTopicName>"),
    ("GAZ030", "<odometryTopic>"),
    ("GAZ030", "<topicName>"),
    ("GAZ030", "<topicName>"),
    ("RCT029", "<robotBaseFrame>"),
]
OLD_TAGS = (
    "updateRate cameraName imageTopicName cameraInfoTopicName frameName hackBaseline distortionK1 "
    "distortionK2 distortionK3 distortionT1 distortionT2 commandTopic odometryTopic odometryFrame "
    "odometryRate robotBaseFrame topicName updateRateHZ gaussianNoise xyzOffset rpyOffset frameName"
).split()


def found(*targets: str) -> list[Diagnostic]:
    report = engine.check(str(MISSION), select=FAMILY, targets=targets)
    assert report.crashed == ()
    return list(report.diagnostics)


def test_as_it_is() -> None:
    heard = found()
    assert sorted((one.code, one.span.text) for one in heard) == ALWAYS
    warnings = [one.code for one in heard if one.severity.value != "info"]
    assert warnings == ["RCT029"]


def test_the_inferred_generation_is_that_of_ros1() -> None:
    assert sorted((one.code, one.span.text) for one in found("classic-ros1")) == ALWAYS


def test_for_ros2_the_old_tags_and_the_old_laser_are_reported() -> None:
    heard = found("classic-ros2")
    (laser,) = [one for one in heard if one.code == "GAZ012"]
    assert laser.severity.value == "error"
    assert laser.span.text == "libgazebo_ros_laser.so"
    assert "use libgazebo_ros_ray_sensor.so" in laser.help
    old = [one for one in heard if one.code == "GAZ016" and one.severity.value == "warning"]
    spans = [span for one in old for span in (one.span, *(place.span for place in one.related))]
    assert Counter(span.text.strip("<>") for span in spans) == Counter(OLD_TAGS)
    assert len({one.span.source for one in old}) == 1
    assert len(old) == 6  # of each plugin, the tags that are renamed, and the others


@pytest.mark.parametrize("target", ["gz-fortress", "gz-harmonic", "gz-jetty"])
def test_gz_loads_none_of_its_plugins(target: str) -> None:
    errors = [one for one in found(target) if one.severity.value == "error"]
    assert [(one.code, one.span.text) for one in errors] == [
        ("GAZ012", "libgazebo_ros_laser.so"),
        ("GAZ012", "libgazebo_ros_camera.so"),
        ("GAZ012", "libgazebo_ros_planar_move.so"),
        ("GAZ012", "libgazebo_ros_imu_sensor.so"),
    ]


def test_no_errors_on_real_robots() -> None:
    """The links that a later version of the PR2 lost had colours and friction: a warning."""
    robots = list(manifest())
    if not robots:
        pytest.skip(f"{SHARED} is not beside this checkout")
    errors: Counter[tuple[str, str]] = Counter()
    for robot in robots:
        report = engine.check(robot.path, arguments=robot.arguments, select=FAMILY)
        assert report.crashed == ()
        errors.update(
            (one.code, one.message.partition(":")[0])
            for one in report.diagnostics
            if one.severity.value == "error"
        )
    assert errors == Counter()


def test_a_hostile_robot_takes_no_time() -> None:
    size = 20_000
    names = "".join(f"<t{n}/>" for n in range(size))
    joints = ",".join(f"j{n}" for n in range(size))
    text = (
        f'<robot name="r"><link name="base"/><gazebo reference="base">{names}</gazebo><gazebo>'
        f'<plugin name="p" filename="libgazebo_ros_planar_move.so">{names}</plugin>'
        f'<plugin name="p" filename="libgazebo_ros_joint_state_publisher.so">'
        f"<jointName>{joints}</jointName></plugin></gazebo></robot>"
    )
    report = engine.check(Source("robot.urdf", text.encode()), select=FAMILY)
    assert report.crashed == ()
    assert {one.code for one in report.diagnostics} == {"GAZ003", "GAZ016", "GAZ021"}
