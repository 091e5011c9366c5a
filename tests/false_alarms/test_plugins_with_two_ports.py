"""GAZ016: a library that was ported to ROS 2 twice, and reads other tags in each port."""

import pytest

from tests.gazebos import BASE, plugin, sensor
from tests.reported import messages

VELODYNE = "libgazebo_ros_velodyne_laser.so"


@pytest.mark.parametrize(
    ("tags", "unknown"),
    [
        ("<frame_name>base</frame_name><gaussian_noise>0.01</gaussian_noise>", []),
        ("<frameName>base</frameName><gaussianNoise>0.01</gaussianNoise>", []),
        ("<ros><remapping>~/out:=points</remapping></ros><noise>1</noise>", ["<noise>"]),
    ],
)
def test_a_velodyne_of_either_port(tags: str, unknown: list[str]) -> None:
    """A rover with the plugin of velodyne_simulator; a fork kept the tags of ROS 1."""
    scanner = sensor("ray", f'<plugin name="p" filename="{VELODYNE}">{tags}</plugin>')
    robot = BASE + scanner + plugin("libgazebo_ros2_control.so")
    found = messages("GAZ016", robot)
    assert [message.partition("element ")[2].split()[0] for message in found] == unknown
