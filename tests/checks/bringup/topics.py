"""Nodes that publish and read topics, for the tests of LAU032."""

from pathlib import Path

from tests.checks.bringup.nodes import NODE
from tests.launched import reported
from urdfkit import Diagnostic


def of_topics(directory: Path, text: str, files: dict[str, str]) -> list[Diagnostic]:
    """What is said of a launch file without lifecycle manager, except that it has none."""
    found = reported(directory, "LAU032", "a.launch.py", text, files)
    return [one for one in found if "lifecycle manager" not in one.message]


IMU = NODE.format(
    "ros_gz_bridge", "parameter_bridge", "arguments=['{}@sensor_msgs/msg/Imu[gz.msgs.IMU'{}]"
)
FILTER = NODE.format("robot_localization", "ekf_node", "parameters=['../ekf.yaml']{}")
EKF = "ekf_filter_node:\n  ros__parameters:\n    imu0: imu\n    imu0_config: []\n"

SCAN = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['{}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan']",
)
SLAM = NODE.format("slam_toolbox", "async_slam_toolbox_node", "{}")

COSTMAP = (
    "local_costmap: {{local_costmap: {{ros__parameters: {{layer: {{observation_sources: cloud, "
    "cloud: {{topic: /points, data_type: {}}}}}}}}}}}\n"
)

BRIDGE = NODE.format("ros_gz_bridge", "parameter_bridge", "arguments=['{}']")
