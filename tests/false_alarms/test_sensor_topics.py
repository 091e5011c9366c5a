"""Sensors whose topics look alike and carry different data."""

import pytest

from urdfkit import check
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.text.source import Source


def _found(*sensors: tuple[str, str, str], target: str = "gz-harmonic") -> list[str]:
    """The messages about sensors of a link, each with its name, type and topic."""
    tags = [sensor_xml(name, kind, f"<topic>{topic}</topic>") for name, kind, topic in sensors]
    inside = robot_xml(solid_xml("base"), gazebo_xml(*tags, reference="base"))
    robot = f'<robot name="r">{inside}</robot>'
    found = check(Source("r.urdf", robot.encode()), select=["GAZ010"], targets=[target])
    return [one.message for one in found.diagnostics]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (("a", "camera", "front/image"), ("b", "camera", "rear/image")),
        (("a", "camera", "camera"), ("b", "rgbd_camera", "camera")),
        (("a", "camera", "$(arg topic)"), ("b", "camera", "$(arg topic)")),
        (("a", "imu", ""), ("b", "gpu_lidar", "")),
    ],
)
def test_topics_of_their_own(first: tuple[str, str, str], second: tuple[str, str, str]) -> None:
    assert _found(first, second) == []


def test_a_topic_of_two_sensors() -> None:
    both = ("a", "gpu_lidar", "scan"), ("b", "gpu_lidar", "/scan")
    (message,) = _found(*both)
    assert message.endswith("both publish on 'scan'")
    assert _found(*both, target="classic-ros2") == []
