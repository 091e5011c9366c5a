from __future__ import annotations

import pytest

from tests.gazebos import BASE, plugin
from tests.reported import fixed, messages, places, reported

MOVE = "libgazebo_ros_planar_move.so"
NEW = "<odometry_frame>odom</odometry_frame>"


@pytest.mark.parametrize(
    ("name", "good"),
    [("a-b", "a_b"), ("a b", "a_b"), ("/a/b", "_a_b"), ("2wd", "_2wd"), ("räder", "r_der")],
)
def test_names_that_ros2_refuses(name: str, good: str) -> None:
    text = BASE + plugin(MOVE, NEW, name)
    (message,) = messages("GAZ034", text)
    assert message == (
        f"plugin '{name}' ({MOVE}) becomes a ROS 2 node, whose name has letters, digits and "
        "underscores only, and no digit first"
    )
    assert places("GAZ034", text) == [(4, name)]
    assert f'<plugin name="{good}"' in fixed("GAZ034", text)


@pytest.mark.parametrize("name", ["a", "A_b2", "_2wd", ""])
def test_names_that_ros2_takes(name: str) -> None:
    assert reported("GAZ034", BASE + plugin(MOVE, NEW, name)) == []


def test_other_plugins_are_no_nodes_of_that_name() -> None:
    text = BASE + plugin(MOVE, "<odometryFrame>odom</odometryFrame>", "a-b")
    assert reported("GAZ034", text) == []
    assert (
        reported("GAZ034", BASE + plugin("gz-sim-imu-system", name="gz::sim::systems::Imu")) == []
    )
    assert reported("GAZ034", BASE + plugin("libvendor.so", name="a-b")) == []
