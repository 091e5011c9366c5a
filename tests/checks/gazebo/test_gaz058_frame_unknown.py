"""GAZ058: see the rule."""

import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.reported import fixed, messages

LASER = '<plugin name="p" filename="libgazebo_ros_laser.so"><frameName>{}</frameName></plugin>'


@pytest.mark.parametrize(
    ("frame", "message"),
    [
        ("basis", "and the robot has no such link"),
        ("robot/lidar", "and the robot has no such link"),
        ("/base", "tf2 refuses the slash at its beginning"),
    ],
)
def test_frames_without_a_link(frame: str, message: str) -> None:
    (reported,) = messages("GAZ058", BASE + sensor("ray", LASER.format(frame)))
    assert f"names frame '{frame}'" in reported
    assert reported.endswith(message)


def test_the_frame_of_a_sensor_of_gz() -> None:
    (reported,) = messages("GAZ058", BASE + sensor("imu", "<gz_frame_id>imu</gz_frame_id>"))
    assert reported == "sensor 's' names frame 'imu', and the robot has no such link"


def test_a_slip_is_mended() -> None:
    text = BASE.replace('"base"', '"laser"') + sensor("ray", LASER.format("lasser"), "laser")
    assert "<frameName>laser<" in fixed("GAZ058", text)


@pytest.mark.parametrize("frame", ["base", "robot/base", "map", "odom_frame", "$(arg x)", ""])
def test_links_and_frames_of_the_world_are_calm(frame: str) -> None:
    assert messages("GAZ058", BASE + sensor("ray", LASER.format(frame))) == []


def test_a_link_whose_name_has_a_slash() -> None:
    text = BASE.replace('"base"', '"rov/imu"')
    tag = "<gz_frame_id>rov/imu</gz_frame_id>"
    assert messages("GAZ058", text + sensor("imu", tag, "rov/imu")) == []


def test_the_frame_of_odometry_comes_from_elsewhere() -> None:
    tags = "<odometryFrame>start</odometryFrame><robotBaseFrame>base</robotBaseFrame>"
    assert messages("GAZ058", BASE + plugin("libgazebo_ros_planar_move.so", tags)) == []


@pytest.mark.parametrize(
    ("file", "tag", "count"),
    [
        ("gz-sim-odometry-publisher-system", "odom_frame", 1),
        ("libgazebo_ros_planar_move.so", "odometry_frame", 1),
        ("libgazebo_ros_planar_move.so", "odometryFrame", 0),  # ROS 1 takes the slash away
    ],
)
def test_the_slash_of_the_frame_of_odometry(file: str, tag: str, count: int) -> None:
    robot = BASE + plugin(file, f"<{tag}>/odom</{tag}>")
    assert len(messages("GAZ058", robot)) == count
