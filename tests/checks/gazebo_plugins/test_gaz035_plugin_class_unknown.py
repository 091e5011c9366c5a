from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import fixed, places, reported

POSES = "gz-sim-pose-publisher-system"


@pytest.mark.parametrize(
    ("file", "known"),
    [
        (POSES, "gz::sim::systems::PosePublisher"),
        (f"lib{POSES}.so", "gz::sim::systems::PosePublisher"),
        ("ignition-gazebo-pose-publisher-system", "ignition::gazebo::systems::PosePublisher"),
    ],
)
@pytest.mark.parametrize("name", ["poses", "gz::sim::PosePublisher", "GZ::sim::systems::Poses"])
def test_a_name_that_is_no_class(name: str, file: str, known: str) -> None:
    text = BASE + plugin(file, name=name)
    (found,) = reported("GAZ035", text)
    assert found.message == (
        f"plugin '{name}' ({file}): the library has no class of that name, but {known}"
    )
    assert places("GAZ035", text) == [(4, name)]
    assert f'<plugin name="{known}"' in fixed("GAZ035", text)
    assert found.fix
    assert not found.fix.safe


@pytest.mark.parametrize(
    ("file", "name"),
    [
        (POSES, "gz::sim::systems::PosePublisher"),
        (POSES, "gz::sim::v8::systems::PosePublisher"),
        ("ignition-gazebo-pose-publisher-system", "ignition::gazebo::systems::PosePublisher"),
        (POSES, ""),  # GAZ010
        ("gz_ros2_control-system", "gz_ros2_control::GazeboSimROS2ControlPlugin"),
        ("ign_ros2_control-system", "ign_ros2_control::IgnitionROS2ControlPlugin"),
        ("libgazebo_ros_planar_move.so", "anything"),  # a label, in Gazebo Classic
        ("libvendor.so", "anything"),
    ],
)
def test_a_name_that_will_do(file: str, name: str) -> None:
    assert reported("GAZ035", BASE + plugin(file, name=name)) == []
