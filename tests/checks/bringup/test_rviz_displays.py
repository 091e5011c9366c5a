"""Displays of RViz, beside what the programs of a launch file publish."""

from pathlib import Path

import pytest

from tests.launched import reported

IMPORT = "from launch_ros.actions import Node\n"
NODE = IMPORT + 'nodes = [Node(package="{}", executable="{}"{})]\n'
TO_SCAN = ("pointcloud_to_laserscan", "pointcloud_to_laserscan_node")


def messages(directory: Path, code: str, text: str, files: dict[str, str]) -> list[str]:
    return [one.message for one in reported(directory / "arm", code, "a.launch.py", text, files)]


RVIZ = """Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/LaserScan
      Topic:
        Reliability Policy: {}
        Value: /{}
"""


@pytest.mark.parametrize(
    ("policy", "topic", "count"),
    [("Reliable", "scan", 1), ("Best Effort", "scan", 0), ("Reliable", "other", 0)],
)
def test_reliable_displays(tmp_path: Path, policy: str, topic: str, count: int) -> None:
    text = NODE.format(*TO_SCAN, "") + (
        'rviz = Node(package="rviz2", executable="rviz2", arguments=["-d", "../a.rviz"])\n'
    )
    found = messages(tmp_path, "LAU027", text, {"a.rviz": RVIZ.format(policy, topic)})
    assert ["best effort" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("driver", "count"),
    [(("slam_toolbox", "slam"), 1), (("sick_scan_xd", "sick_generic_caller"), 0)],
)
def test_another_lidar_publishes_the_topic(
    tmp_path: Path, driver: tuple[str, str], count: int
) -> None:
    """fbot_description: a launch file with a view for each of its lidars."""
    rviz = ', arguments=["-d", "../a.rviz"])]\nother = [Node(package="{}", executable="{}"'
    files = {
        "a.rviz": RVIZ.format("Reliable", "scan"),
        "launch/b.launch.py": NODE.format(*TO_SCAN, ""),
    }
    text = NODE.format("rviz2", "rviz2", rviz.format(*driver))
    found = messages(tmp_path, "LAU027", text, files)
    assert ["best effort" in one for one in found] == [True] * count


def test_a_driver_that_an_argument_chooses_among_others(tmp_path: Path) -> None:
    """linorobot2: seven lidars, of which one has best effort."""
    rviz = 'rviz = Node(package="rviz2", executable="rviz2", arguments=["-d", "../a.rviz"])\n'
    chosen = ', condition=LaunchConfigurationEquals("sensor", "kinect")'
    for condition, count in (("", 1), (chosen, 0)):
        text = NODE.format(*TO_SCAN, condition) + rviz
        found = messages(tmp_path, "LAU027", text, {"a.rviz": RVIZ.format("Reliable", "scan")})
        assert ["best effort" in one for one in found] == [True] * count


SCANS = """
nodes += [
    Node(package="ros_gz_bridge", executable="parameter_bridge", arguments=[{}]),
]
"""
SCAN = "    - {{Class: rviz_default_plugins/LaserScan, Enabled: {}, Topic: {{Value: {}}}}}\n"
TWO = "Visualization Manager:\n  Displays:\n{}" + SCAN


@pytest.mark.parametrize(
    ("published", "enabled", "count"),
    [
        (("/front", "/rear"), "true", 1),
        (("/front", "/rear"), "false", 0),
        (("/front", "/scan"), "true", 0),
        (("/front",), "true", 0),  # perhaps the other one is for another robot
    ],
)
def test_one_of_two_displays(
    tmp_path: Path, published: tuple[str, ...], enabled: str, count: int
) -> None:
    bridged = ", ".join(
        f"'{topic}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan'" for topic in published
    )
    text = NODE.format("rviz2", "rviz2", ', arguments=["-d", "../a.rviz"]') + SCANS.format(bridged)
    files = {"a.rviz": TWO.format(SCAN.format("true", "/front"), enabled, "/scan")}
    found = messages(tmp_path, "LAU032", text, files)
    assert ["'/scan'" in one and "'/rear'" in one for one in found] == [True] * count
