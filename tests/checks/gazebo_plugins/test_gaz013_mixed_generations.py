from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import reported

OLD, NEW = plugin("libgazebo_ros_laser.so"), plugin("libgazebo_ros_ray_sensor.so")
BOTH, GZ = plugin("libgazebo_ros_p3d.so"), plugin("gz-sim-diff-drive-system")
BARE = plugin("libLiftDragPlugin.so")


@pytest.mark.parametrize("pair", [OLD + NEW, OLD + GZ, BOTH + GZ, BARE + GZ, OLD + BOTH + NEW])
def test_no_gazebo_loads_both(pair: str) -> None:
    (found,) = reported("GAZ013", BASE + pair)
    assert [note.span.line for note in found.related] == [4], "the first plugin"


@pytest.mark.parametrize("pair", [OLD + BOTH, NEW + BOTH, BARE + OLD, BARE + NEW, GZ + GZ, ""])
def test_one_gazebo_loads_all(pair: str) -> None:
    assert reported("GAZ013", BASE + pair) == []


def test_unknown_plugins_do_not_count() -> None:
    assert reported("GAZ013", BASE + OLD + plugin("libvendor.so")) == []


def test_a_given_target_makes_it_the_business_of_another_rule() -> None:
    assert reported("GAZ013", BASE + OLD + GZ, targets=("gz-harmonic",)) == []
    assert len(reported("GAZ013", BASE + OLD + GZ, targets=("gz-harmonic", "classic-ros1"))) == 1


def test_the_message() -> None:
    (found,) = reported("GAZ013", BASE + BOTH + GZ)
    assert found.message == (
        "plugin 'p' (gz-sim-diff-drive-system) is for gz-sim, and plugin 'p' "
        "(libgazebo_ros_p3d.so) for Gazebo Classic with ROS 1 or Gazebo Classic with ROS 2"
    )
