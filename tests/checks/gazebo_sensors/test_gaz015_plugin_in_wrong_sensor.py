from __future__ import annotations

import pytest

from tests.gazebos import BASE, sensor
from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("kind", "file", "wanted"),
    [
        ("gpu_ray", "libgazebo_ros_laser.so", "'ray'"),
        ("ray", "libgazebo_ros_gpu_laser.so", "'gpu_ray'"),
        ("camera", "libgazebo_ros_openni_kinect.so", "'depth'"),
        ("imu", "libgazebo_ros_bumper.so", "'contact'"),
    ],
)
def test_the_wrong_sensor(kind: str, file: str, wanted: str) -> None:
    text = BASE + sensor(kind, f'<plugin name="p" filename="{file}"/>')
    message = f"plugin 'p' ({file}) serves a sensor of type {wanted}, and this is '{kind}'"
    assert messages("GAZ015", text) == [message]
    assert places("GAZ015", text) == [(4, kind)]


@pytest.mark.parametrize(
    ("kind", "file"),
    [
        ("ray", "libgazebo_ros_laser.so"),
        ("lidar", "libgazebo_ros_laser.so"),
        ("gpu_lidar", "libgazebo_ros_gpu_laser.so"),
        ("depth", "libgazebo_ros_camera.so"),
        ("depth_camera", "libgazebo_ros_openni_kinect.so"),
        ("wideanglecamera", "libgazebo_ros_camera.so"),
        ("wide_angle_camera", "libgazebo_ros_camera.so"),
        ("navsat", "libgazebo_ros_gps_sensor.so"),
        ("imu", "libvendor.so"),
        ("imu", "libgazebo_ros_planar_move.so"),
    ],
)
def test_the_right_sensor(kind: str, file: str) -> None:
    assert reported("GAZ015", BASE + sensor(kind, f'<plugin name="p" filename="{file}"/>')) == []


def test_a_sensor_without_a_type_is_told_elsewhere() -> None:
    plugin = '<plugin name="p" filename="libgazebo_ros_laser.so"/>'
    text = f'{BASE}<gazebo reference="base"><sensor name="s">{plugin}</sensor></gazebo>'
    assert reported("GAZ015", text) == []
