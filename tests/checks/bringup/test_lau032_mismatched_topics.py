"""LAU032: see the rule."""

from pathlib import Path

import pytest

from tests.checks.bringup.nodes import NODE, SPAWNER, STATE
from tests.launched import reported
from tests.naming import naming, values
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


SCAN = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['{}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan']",
)
SLAM = NODE.format("slam_toolbox", "async_slam_toolbox_node", "{}")


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


COSTMAP = (
    "local_costmap: {{local_costmap: {{ros__parameters: {{layer: {{observation_sources: cloud, "
    "cloud: {{topic: /points, data_type: {}}}}}}}}}}}\n"
)


@pytest.mark.parametrize(
    ("message", "words"),
    [
        ("PointCloud2", ""),
        ("LaserScan", naming("local_costmap", "LaserScan", "/points", "PointCloud2")),
    ],
)
def test_message_of_an_input(tmp_path: Path, message: str, words: str) -> None:
    topics = [
        "/points@sensor_msgs/msg/PointCloud2[gz.msgs.PointCloudPacked",
        "/scan@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan",
    ]
    text = NODE.format("ros_gz_bridge", "parameter_bridge", f"arguments={topics}")
    text += NODE.format(
        "nav2_controller", "controller_server", f"parameters=['{tmp_path}/nav2.yaml']"
    )
    files = {"nav2.yaml": COSTMAP.format(message)}
    assert [one.message for one in of_topics(tmp_path, text, files)] == [words] * bool(words)


DRIVE = """
controller_manager: {ros__parameters: {base: {type: diff_drive_controller/DiffDriveController}}}
base: {ros__parameters: {left_wheel_names: [l], right_wheel_names: [r]}}
"""


@pytest.mark.parametrize(("topic", "count"), [("base/odom", 0), ("wheel/odom", 1)])
def test_odometry_of_another_launch_file(tmp_path: Path, topic: str, count: int) -> None:
    control = NODE.format(
        "controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']"
    ) + SPAWNER.format(["base"])
    files = {
        "launch/control.launch.py": control,
        "c.yaml": DRIVE,
        "ekf.yaml": f"ekf: {{ros__parameters: {{odom0: {topic}, odom0_config: [true]}}}}\n",
    }
    text = NODE.format(
        "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert ["on '/base/odom'" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("topic", "count"), [("/map", 0), ("/hall/map", 1)])
def test_the_map_of_a_costmap(tmp_path: Path, topic: str, count: int) -> None:
    yaml = (
        "global_costmap: {global_costmap: {ros__parameters: {plugins: [fixed], fixed: "
        f"{{plugin: 'nav2_costmap_2d::StaticLayer', map_topic: {topic}}}}}}}}}\n"
    )
    text = NODE.format("nav2_map_server", "map_server", "name='map_server'") + NODE.format(
        "nav2_planner", "planner_server", f"parameters=['{tmp_path}/nav2.yaml']"
    )
    found = of_topics(tmp_path, text, {"nav2.yaml": yaml})
    assert ["on '/map'" in one.message for one in found] == [True] * count


LIDAR = (
    '<robot name="r"><link name="l"/><gazebo reference="l"><sensor name="s" type="gpu_lidar">'
    "{}</sensor></gazebo></robot>"
)
BRIDGE = NODE.format("ros_gz_bridge", "parameter_bridge", "arguments=['{}']")


@pytest.mark.parametrize(
    ("tags", "bridge", "more", "words"),
    [
        ("<topic>scan</topic>", SCAN.format("/scan"), "", ""),
        (
            "<topic>scan</topic>",
            BRIDGE.format("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"),
            "",
            "'/scan' of sensor 's'",
        ),
        ("<topic>scan</topic>", "", "", ""),  # another simulator
        (
            "<topic>scan</topic>",
            BRIDGE.format("/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock"),
            NODE.format("sllidar_ros2", "sllidar_node", ""),
            "",
        ),
        (
            "<topic>scan</topic>",
            SCAN.format("/rear"),
            "",
            "'/scan' of sensor 's'",
        ),
        ("<topic>front</topic>", SCAN.format("/rear"), "", "on '/rear'"),
    ],
)
def test_a_sensor_that_is_not_bridged(
    tmp_path: Path, tags: str, bridge: str, more: str, words: str
) -> None:
    text = (
        STATE.format(
            f", parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read(), "
            "'use_sim_time': True}]"
        )
        + bridge
        + more
        + NODE.format(
            "nav2_amcl", "amcl", "parameters=[{'scan_topic': 'scan', 'use_sim_time': True}]"
        )
        + NODE.format(
            "slam_toolbox", "async_slam_toolbox_node", f"parameters=['{tmp_path}/slam.yaml']"
        )
    )
    slam = "slam_toolbox: {ros__parameters: {scan_topic: /scan, use_sim_time: true}}\n"
    files = {"r.urdf": LIDAR.format(tags), "slam.yaml": slam}
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    found = [one for one in found if "waits for" in one.message]
    assert [words in one.message for one in found] == [True] * bool(words)


@pytest.mark.parametrize("topic", ["/camera/points", "/camera/cloud"])
def test_the_nearest_sensor_that_is_not_bridged(tmp_path: Path, topic: str) -> None:
    camera = '<sensor name="eye" type="rgbd_camera"><topic>camera</topic></sensor>'
    model = LIDAR.format("<topic>scan</topic>").replace("</gazebo>", f"{camera}</gazebo>")
    text = (
        STATE.format(f", parameters=[{{'robot_description': open('{tmp_path}/r.urdf').read()}}]")
        + SCAN.format("/scan")
        + NODE.format(
            "nav2_controller", "controller_server", f"parameters=['{tmp_path}/nav2.yaml']"
        )
    )
    nav2 = COSTMAP.format("PointCloud2").replace("/points", topic)
    files = {"r.urdf": model, "nav2.yaml": nav2}
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    assert [values(one.message)[-2:] for one in found if topic in one.message] == [
        ["/camera/points", "eye"]
    ]


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
    ("info", "mask", "words"),
    [
        ("/filter_info", "/mask", ""),
        ("/info", "/mask", "on '/filter_info'"),
        ("/filter_info", "/masks", "on '/mask'"),
    ],
)
def test_filters_of_a_costmap(tmp_path: Path, info: str, mask: str, words: str) -> None:
    yaml = (
        "global_costmap: {global_costmap: {ros__parameters: {filters: [keep], keep: "
        f"{{plugin: 'nav2_costmap_2d::KeepoutFilter', filter_info_topic: {info}}}}}}}}}\n"
    )
    server = f"parameters=[{{'filter_info_topic': '/filter_info', 'mask_topic': '{mask}'}}]"
    text = (
        NODE.format(
            "nav2_map_server", "map_server", "name='masks', parameters=[{'topic_name': '/mask'}]"
        )
        + NODE.format("nav2_map_server", "costmap_filter_info_server", server)
        + NODE.format("nav2_planner", "planner_server", f"parameters=['{tmp_path}/nav2.yaml']")
    )
    found = of_topics(tmp_path, text, {"nav2.yaml": yaml})
    assert [words in one.message for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("of_filter", "of_drive", "more", "count"),
    [
        ("false", "false", "", 1),
        ("true", "false", "", 0),
        ("true, world_frame: map", "false", "", 1),
        ("true, world_frame: map, odom_frame: map", "false", "", 0),
        ("true, world_frame: map", "true", "", 0),
        ("false", "true", "", 0),
        ("false", "false", NODE.format("rf2o_laser_odometry", "rf2o", ""), 0),
        (
            "false",
            "false",
            BRIDGE.format("/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"),
            0,
        ),
    ],
)
def test_nothing_publishes_odometry(
    tmp_path: Path, of_filter: str, of_drive: str, more: str, count: int
) -> None:
    drive = DRIVE.replace("right_wheel", f"enable_odom_tf: {of_drive}, right_wheel")
    files = {
        "c.yaml": drive,
        "ekf.yaml": f"ekf: {{ros__parameters: {{publish_tf: {of_filter}, "
        "odom0: base/odom, odom0_config: [true]}}\n",
    }
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["base"])
        + NODE.format(
            "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
        )
        + more
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, files)
    help = f"write {'world_frame: odom' if 'world' in of_filter else 'publish_tf: true'}"
    assert [one.help for one in found if "odometry" in one.message] == [help] * count


@pytest.mark.parametrize(
    ("of_drive", "package", "more", "count"),
    [
        ("false", "nav2_controller", "", 1),
        ("true", "nav2_controller", "", 0),
        ("false", "rviz2", "", 0),
        ("false", "nav2_controller", NODE.format("topic_tools", "relay", ""), 1),
        ("false", "nav2_controller", NODE.format("rf2o_laser_odometry", "rf2o", ""), 0),
        ("false", "nav2_controller", NODE.format("robot_localization", "ekf_node", ""), 0),
    ],
)
def test_nothing_publishes_the_odometry_of_navigation(
    tmp_path: Path, of_drive: str, package: str, more: str, count: int
) -> None:
    drive = DRIVE.replace("right_wheel", f"enable_odom_tf: {of_drive}, right_wheel")
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["base"])
        + NODE.format(package, "server", "")
        + more
    )
    found = reported(tmp_path, "LAU032", "a.launch.py", text, {"c.yaml": drive})
    help = "write enable_odom_tf: true"
    assert [one.help for one in found if "odometry" in one.message] == [help] * count


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
