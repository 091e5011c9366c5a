"""LAU032: programs that may publish what no known one does."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE
from tests.checks.bringup.topics import EKF, FILTER, IMU, SCAN, SLAM, of_topics
from tests.launched import reported
from tests.naming import values

PARTS = {
    "scope": "SetParameter('use_sim_time', True)\n",
    "bridge": NODE.format(
        "ros_gz_bridge",
        "parameter_bridge",
        "arguments=['/odom_gz@nav_msgs/msg/Odometry[gz.msgs.Odometry'], "
        "remappings=[('/odom_gz', '/odom')]",
    ),
    "own": NODE.format("mine", "monitor", ""),
    "renamed": SCAN.format("/lidar").replace(
        "LaserScan']", "LaserScan'], remappings=[('/lidar', '/scan')]"
    ),
}
PROCESS = "ExecuteProcess(cmd={})\n"
PARTS |= {
    "sleep": PROCESS.format(["/bin/sleep", "3"]),
    "controllers": PROCESS.format(["ros2", "control", "load_controller", "arm"]),
    "command": PROCESS.format(["ros2", "topic", "pub", "/scan", "sensor_msgs/msg/LaserScan"]),
    "shell": PROCESS.format(["sleep 3; ./driver"]),
    "unknown": "ExecuteProcess(cmd=[name])\n",
}
READING = """
# It never publishes a LaserScan.
from sensor_msgs.msg import (
    Imu,
    LaserScan,
)

class Monitor(Node):
    def start(self):
        self.create_subscription(LaserScan, "/scan", self.read, 10)

    def read(self, message: LaserScan):
        print("LaserScan received")
"""
OWN = {
    "src/mine/package.xml": "<package><name>mine</name><depend>base</depend></package>",
    "src/mine/monitor.py": "from sensor_msgs.msg import JointState",
    "src/mine/launch/a.launch.py": "SCAN = 'LaserScan'",
}
BASE = {
    "src/base/package.xml": "<package><name>base</name></package>",
    "src/base/node.cpp": "create_publisher<sensor_msgs::msg::LaserScan>",
}


@pytest.mark.parametrize(
    ("part", "files", "count"),
    [
        ("scope", {}, 1),
        ("bridge", {}, 1),
        ("renamed", {}, 0),
        ("own", {}, 0),  # it may publish scans
        ("own", OWN, 1),
        ("own", {**OWN, **BASE}, 0),
        ("own", {**OWN, "src/mine/monitor.py": "publisher = create_generic_publisher"}, 0),
        ("own", {**OWN, "src/mine/monitor.py": READING}, 1),
        ("own", {**OWN, "src/mine/monitor.py": READING + "kind = LaserScan"}, 0),
        ("own", {**OWN, "src/mine/monitor.py": READING.replace("Imu", "Imu as I")}, 0),
        ("sleep", {}, 1),
        ("controllers", {}, 1),
        ("command", {}, 0),
        ("shell", {}, 0),
        ("unknown", {}, 0),
        ("own", {**OWN, "src/mine/monitor.py": "#" * 200_000}, 0),
    ],
)
def test_programs_that_publish_no_scan(
    tmp_path: Path, part: str, files: dict[str, str], count: int
) -> None:
    """Such as the programs of the workspace that do not name the message."""
    text = SCAN.format("/lidar") + SLAM.format("") + PARTS[part]
    files = {"package.xml": "<package><name>top</name></package>", **files}
    found = of_topics(tmp_path, text, files)
    assert [values(one.message)[1] for one in found] == ["/scan"] * count


@pytest.mark.parametrize(
    ("path", "text", "count"),
    [
        ("launch/all.launch.py", "path = 'a.launch.py'", 0),
        ("test/all.launch.py", "path = 'a.launch.py'", 1),
        ("launch/all.launch.py", "# see a.launch.py", 1),
        ("launch/all.launch.py", '"""After\na.launch.py."""', 1),
        ("launch/all.launch.xml", "<launch><!-- a.launch.py --></launch>", 1),
    ],
)
def test_a_launch_file_that_another_one_may_include(
    tmp_path: Path, path: str, text: str, count: int
) -> None:
    nodes = IMU.format("/imu/data", "") + FILTER.format("")
    found = reported(tmp_path, "LAU032", "a.launch.py", nodes, {path: text, "ekf.yaml": EKF})
    assert ["waits for" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("kind", "count"),
    [
        ("joint_trajectory_controller/JointTrajectoryController", 1),
        ("imu_sensor_broadcaster/IMUSensorBroadcaster", 0),
    ],
)
def test_a_spawner_that_may_not_run(tmp_path: Path, kind: str, count: int) -> None:
    """Only a controller that publishes such messages may be the one that is meant."""
    condition = "condition=IfCondition(LaunchConfiguration('x'))"
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + NODE.format("controller_manager", "spawner", f"arguments=['arm'], {condition}")
        + IMU.format("/imu/data", "")
        + FILTER.format("")
    )
    yaml = f"controller_manager:\n  ros__parameters:\n    arm: {{type: {kind}}}\n"
    found = of_topics(tmp_path, text, {"ekf.yaml": EKF, "c.yaml": yaml})
    assert len([one for one in found if "waits for '/imu'" in one.message]) == count


@pytest.mark.parametrize(
    ("topics", "help"),
    [
        (("/front_scan", "/rear_scan"), "write /rear_scan or /front_scan"),
        (("/front_scan", "/lidar"), "write /front_scan"),
        (("/front_lidar", "/rear_lidar"), "write /rear_lidar"),
    ],
)
def test_all_topics_that_may_be_meant(tmp_path: Path, topics: tuple[str, str], help: str) -> None:
    text = "".join(map(SCAN.format, topics)) + SLAM.format("parameters=['../slam.yaml']")
    slam = "slam_toolbox:\n  ros__parameters:\n    scan_topic: /scan\n"
    (found,) = of_topics(tmp_path, text, {"slam.yaml": slam})
    assert found.help == help
