"""LAU032: see the rule."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER
from tests.checks.bringup.topics import BRIDGE, EKF, FILTER, IMU, SCAN, SLAM, of_topics
from tests.launched import reported
from tests.naming import naming, values


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (IMU.format("/imu", "") + FILTER.format(""), 0),
        (IMU.format("/imu/data", "") + FILTER.format(""), 1),
        (IMU.format("imu", "], namespace='robot', parameters=[") + FILTER.format(""), 1),
        (IMU.format("/imu", "], namespace='robot', parameters=[") + FILTER.format(""), 0),
        (IMU.format("imu", "], namespace=name, parameters=[") + FILTER.format(""), 0),
        (FILTER.format(""), 0),  # its publisher is unknown
        (IMU.format("/imu/data", "") + FILTER.format("") + NODE.format("a", "driver", ""), 0),
        (IMU.format("/imu/data", "") + FILTER.format(", remappings=[('imu', 'imu/data')]"), 0),
        (IMU.format("/imu/data", "") + FILTER.format(", namespace='robot'"), 0),
        (
            IMU.format("/imu/data", "")
            + FILTER.format(", remappings=[('odometry/filtered', '/odom')]"),
            1,
        ),
    ],
)
def test_topics(tmp_path: Path, text: str, count: int) -> None:
    found = reported(tmp_path, "LAU032", "a.launch.py", text, {"ekf.yaml": EKF})
    assert len([one for one in found if "waits for '/imu'" in one.message]) == count


CLOUD = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked']",
)
BUILDER = """from moveit_configs_utils import MoveItConfigsBuilder
config = MoveItConfigsBuilder("arm", package_name="arm").sensors_3d("config/sensors.yaml")
config = config.to_moveit_configs()
"""


@pytest.mark.parametrize(("topic", "count"), [("/points", 0), ("/cloud", 1), ("''", 0)])
def test_the_octomap(tmp_path: Path, topic: str, count: int) -> None:
    plugin = "sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater"
    yaml = f"sensors: [a]\na:\n  {plugin}\n  point_cloud_topic: {topic}\n"
    found = of_topics(tmp_path / "arm", BUILDER + CLOUD, {"config/sensors.yaml": yaml})
    assert ["'move_group' waits for '/cloud'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(
    ("topic", "more", "count"),
    [
        ("/points", "", 0),
        ("/cloud", "", 1),
        ("/cloud", NODE.format("a", "driver", ""), 0),  # it may publish the cloud
    ],
)
def test_the_octomap_of_an_included_file(tmp_path: Path, topic: str, more: str, count: int) -> None:
    plugin = "sensor_plugin: occupancy_map_monitor/PointCloudOctomapUpdater"
    included = "IncludeLaunchDescription(os.path.join(os.path.dirname(__file__), 'a.launch.py'))\n"
    files = {
        "config/sensors.yaml": f"sensors: [a]\na:\n  {plugin}\n  point_cloud_topic: {topic}\n",
        "launch/all.launch.py": f"import os\n{CLOUD}{more}{included}",
    }
    found = of_topics(tmp_path / "arm", BUILDER, files)
    expected = naming("move_group", "/cloud", "PointCloud2", "/points")
    assert [one.message for one in found] == [expected] * count


@pytest.mark.parametrize(
    ("condition", "count"),
    [("", 1), (", condition=UnlessCondition(LaunchConfiguration('sim'))", 1)],
)
def test_odometry_of_an_optional_controller_manager(
    tmp_path: Path, condition: str, count: int
) -> None:
    """Its spawners, which have no condition, tell what it publishes."""
    files = {
        "ekf.yaml": "ekf: {ros__parameters: {odom0: drive/odm, odom0_config: []}}\n",
        "c.yaml": "controller_manager: {ros__parameters: "
        "{drive: {type: diff_drive_controller/DiffDriveController}}}\n",
    }
    manager = "parameters=['../c.yaml']" + condition
    text = NODE.format("controller_manager", "ros2_control_node", manager)
    text += SPAWNER.format(["drive"]) + FILTER.format("")
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    expected = naming("ekf", "/drive/odm", "Odometry", "/drive/odom")
    assert [one.message for one in found] == [expected] * count


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (SCAN.format("/scan") + SLAM.format(""), 0),
        (SCAN.format("/lidar") + SLAM.format(""), 1),
        (SCAN.format("/lidar") + SLAM.format("parameters=[{'scan_topic': '/lidar'}]"), 0),
        (SCAN.format("/lidar") + SLAM.format("remappings=[('scan', 'lidar')]"), 0),
        (SLAM.format(""), 0),  # its publisher is unknown
    ],
)
def test_default_topics(tmp_path: Path, text: str, count: int) -> None:
    found = reported(tmp_path, "LAU032", "a.launch.py", text)
    expected = ["async_slam_toolbox_node", "/scan"]
    assert [values(one.message)[:2] for one in found] == [expected] * count


@pytest.mark.parametrize(
    ("remappings", "count"),
    [([("cloud_in", "/points")], 0), ([], 1), ([("cloud_in", "/cloud")], 1)],
)
def test_default_topics_of_a_program(
    tmp_path: Path, remappings: list[tuple[str, str]], count: int
) -> None:
    points = "/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked"
    text = BRIDGE.format(points) + NODE.format(
        "pointcloud_to_laserscan", "pointcloud_to_laserscan_node", f"remappings={remappings}"
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text)
    assert [one.help for one in found] == ["remap cloud_in to /points"] * count


@pytest.mark.parametrize(
    ("scope", "count"),
    [
        ('<set_parameter name="use_sim_time" value="true"/>', 1),
        ('<set_use_sim_time value="true"/>', 1),
        ('<set_parameter name="scan_topic" value="lidar"/>', 0),
        ('<push_ros_namespace namespace="robot"/>', 0),
    ],
)
def test_the_scope_of_the_time(tmp_path: Path, scope: str, count: int) -> None:
    """Topics do not depend on it, but on all else that applies to several nodes."""
    nodes = (
        '<node pkg="slam_toolbox" exec="async_slam_toolbox_node"/>'
        '<node pkg="ros_gz_bridge" exec="parameter_bridge" '
        'args="/lidar@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"/>'
    )
    found = reported(tmp_path, "LAU032", "a.launch.xml", scope + nodes)
    assert len([one for one in found if "waits for '/scan'" in one.message]) == count
