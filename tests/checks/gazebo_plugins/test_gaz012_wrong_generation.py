from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.reported import reported

MESSAGE = (
    "plugin 'p' (libgazebo_ros_laser.so) is a plugin of Gazebo Classic with ROS 1, and the robot "
    "is for Gazebo Classic with ROS 2"
)
HELP = "take libgazebo_ros_ray_sensor.so (with output_type sensor_msgs/LaserScan), and see its tags"
LASER = BASE + sensor("ray", '<plugin name="p" filename="libgazebo_ros_laser.so"/>')


def heard(text: str, *targets: str) -> list[tuple[str, str, str]]:
    found = reported("GAZ012", text, targets=targets)
    return [(one.severity.value, one.message, one.help) for one in found]


def test_a_library_that_ros2_no_longer_has() -> None:
    assert heard(LASER, "classic-ros2") == [
        (
            "error",
            MESSAGE,
            HELP,
        )
    ]
    assert heard(LASER, "classic-ros1") == []
    assert heard(LASER, "classic-ros1", "classic-ros2") == []


@pytest.mark.parametrize("target", ["gz-fortress", "gz-harmonic", "gz-jetty"])
def test_the_successor_of_the_successor(target: str) -> None:
    ((severity, _, help),) = heard(BASE + plugin("libgazebo_ros_skid_steer_drive.so"), target)
    assert severity == "error"
    assert help == "take gz-sim-diff-drive-system, and see its tags"


def test_gz_sim_in_classic() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    assert [help for _, _, help in heard(text, "classic-ros1")] == [
        "nothing is known to take its place there"
    ]
    assert heard(text, "gz-harmonic") == []


def test_the_classes_of_gz_sim_in_fortress() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    assert [help for _, _, help in heard(text, "gz-fortress")] == [
        "take the names of Fortress: ignition-gazebo-... and ignition::gazebo::systems::..."
    ]
    old = plugin("ignition-gazebo-diff-drive-system", name="ignition::gazebo::systems::DiffDrive")
    assert heard(BASE + old, "gz-fortress") == []


def test_without_a_gazebo_among_the_targets_nothing_is_wrong() -> None:
    assert heard(LASER, "ros2", "moveit") == []
    assert heard(LASER) == [], "the plugin itself tells the generation"


def test_a_plugin_without_ros_runs_with_both() -> None:
    text = BASE + plugin("libLiftDragPlugin.so")
    assert heard(text, "classic-ros1") == []
    assert heard(text, "classic-ros2") == []
    assert len(heard(text, "gz-jetty")) == 1


def test_of_a_vendors_plugin_there_may_be_a_port() -> None:
    text = BASE + plugin("libhector_gazebo_ros_imu.so")
    assert heard(text, "classic-ros2") == []
    assert len(heard(text, "gz-harmonic")) == 1


def test_an_unknown_plugin_is_of_no_generation() -> None:
    assert heard(BASE + plugin("libvendor.so"), "gz-harmonic") == []


def test_the_names_of_fortress_are_a_pure_rename() -> None:
    text = BASE + plugin("gz-sim-diff-drive-system", name="gz::sim::systems::DiffDrive")
    (found,) = reported("GAZ012", text, targets=("gz-fortress",))
    assert found.fix is not None
    assert [edit.text for edit in found.fix.edits] == [
        "ignition-gazebo-diff-drive-system",
        "ignition::gazebo::systems::DiffDrive",
    ]
    (found,) = reported("GAZ012", LASER, targets=("classic-ros2",))
    assert found.fix is None
