"""What a Classic plugin gives away of its generation."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.gazebos import BASE, plugin
from urdfkit.examples import whole_robot
from urdfkit.resolve import Resolver
from urdfkit.source import Source
from urdfkit.subject import Subject

MOVE = "libgazebo_ros_planar_move.so"
OLD, NEW = "<odometryFrame>o</odometryFrame>", "<odometry_frame>o</odometry_frame>"
ROS = "<ros><namespace>a</namespace></ros>"


def inferred(text: str, folder: Path, build: str = "") -> tuple[str, ...]:
    if build:
        manifest = f"<package><name>p</name><buildtool_depend>{build}</buildtool_depend></package>"
        (folder / "package.xml").write_text(manifest)
    source = Source(str(folder / "robot.urdf"), whole_robot(BASE + text).encode())
    names = Subject(source, Resolver(environment={})).targets.names
    return tuple(name for name in names if name.startswith(("classic", "gz")))


@pytest.mark.parametrize(
    ("file", "tags", "build", "generation"),
    [
        (MOVE, "", "", "classic-ros1"),
        (MOVE, OLD, "", "classic-ros1"),
        (MOVE, NEW, "", "classic-ros2"),
        (MOVE, OLD, "ament_cmake", "classic-ros2"),
        (MOVE, NEW, "catkin", "classic-ros1"),
        (MOVE, ROS, "catkin", "classic-ros2"),
        ("libgazebo_ros_ray_sensor.so", "", "", "classic-ros2"),
        ("libgazebo_ros_laser.so", NEW, "", "classic-ros1"),
        ("libgazebo_ros_laser.so", "", "ament_cmake", "classic-ros2"),
        ("gz-sim-imu-system", "", "", "gz-harmonic"),
        ("ignition-gazebo-imu-system", "", "", "gz-fortress"),
    ],
)
def test_generation(file: str, tags: str, build: str, generation: str, tmp_path: Path) -> None:
    assert inferred(plugin(file, tags), tmp_path, build) == (generation,)
