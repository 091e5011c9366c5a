"""Sensors whose topics look alike and carry different data."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from urdfkit import check
from urdfkit.robot.samples import robot_xml
from urdfkit.ros.gazebo.samples import gazebo_xml, sensor_xml, solid_xml
from urdfkit.text.source import Source


def _found(*sensors: tuple[str, str, str], target: str = "gz-harmonic") -> list[str]:
    """The messages about sensors of a link, each with its name, type and topic."""
    tags = [sensor_xml(name, kind, f"<topic>{topic}</topic>") for name, kind, topic in sensors]
    inside = robot_xml(solid_xml("base"), gazebo_xml(*tags, reference="base"))
    robot = f'<robot name="r">{inside}</robot>'
    found = check(Source("r.urdf", robot.encode()), select=["GAZ010"], targets=[target])
    return [one.message for one in found.diagnostics]


@pytest.mark.parametrize(
    ("first", "second"),
    [
        (("a", "camera", "front/image"), ("b", "camera", "rear/image")),
        (("a", "camera", "camera"), ("b", "rgbd_camera", "camera")),
        (("a", "camera", "$(arg topic)"), ("b", "camera", "$(arg topic)")),
        (("a", "imu", ""), ("b", "gpu_lidar", "")),
    ],
)
def test_topics_of_their_own(first: tuple[str, str, str], second: tuple[str, str, str]) -> None:
    assert _found(first, second) == []


def test_a_topic_of_two_sensors() -> None:
    both = ("a", "gpu_lidar", "scan"), ("b", "gpu_lidar", "/scan")
    (message,) = _found(*both)
    assert message == naming("b", "base", "a", "base", "both", "scan")
    assert _found(*both, target="classic-ros2") == []


LIDARS = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">
<xacro:arg name="lidar" default="3d"/><link name="base"/><gazebo reference="base">
<xacro:if value="${'$(arg lidar)' == '3d'}">
<sensor name="front" type="gpu_lidar"><topic>/lidar_3d</topic></sensor></xacro:if>
<xacro:if value="${'$(arg lidar)' == '2d'}">
<sensor name="front" type="gpu_lidar"><topic>/scan</topic></sensor></xacro:if></gazebo></robot>"""
BRIDGE = """\
from launch_ros.actions import Node
from launch.substitutions import Command, FindPackageShare, PathJoinSubstitution

robot = PathJoinSubstitution([FindPackageShare("arm"), "urdf", "r.urdf.xacro"])
nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher",
         parameters=[{"robot_description": Command(["xacro ", robot])}]),
    Node(package="ros_gz_bridge", executable="parameter_bridge", arguments=[
         "%s@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan"]),
]
"""


@pytest.mark.parametrize(
    ("topic", "count"), [("/scan", 0), ("/scan/points", 0), ("/lidar_3d/ranges", 1), ("/front", 1)]
)
def test_a_bridge_for_the_lidars_of_all_arguments(tmp_path: Path, topic: str, count: int) -> None:
    """A robot with a lidar in 2D or 3D, of which one file bridges the topics."""
    files = {"urdf/r.urdf.xacro": LIDARS}
    found = reported(tmp_path / "arm", "LAU020", "a.launch.py", BRIDGE % topic, files)
    assert len(found) == count


CAMERA = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>
<gazebo reference="base"><sensor name="front" type="rgbd_camera"><topic>front</topic></sensor>
</gazebo></robot>"""


@pytest.mark.parametrize(
    ("topic", "help"),
    [
        ("thermal", "add one to the robot, or remove the topic from the bridge"),
        ("front/deph_image", "write /front/depth_image"),
    ],
)
def test_an_image_that_no_camera_of_the_robot_has(tmp_path: Path, topic: str, help: str) -> None:
    """A thermal camera of another arm: not the depth of the camera that is bridged."""
    bridge = BRIDGE.replace("LaserScan", "Image")
    both = f'{topic}@sensor_msgs/msg/Image[gz.msgs.Image", "/front/image'
    files = {"urdf/r.urdf.xacro": CAMERA}
    (found,) = reported(tmp_path / "arm", "LAU020", "a.launch.py", bridge % both, files)
    assert found.help == help


CALLED = """<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="base"/>
<xacro:macro name="lidar" params="link topic"><gazebo reference="${link}">
<sensor name="front" type="gpu_lidar">%s</sensor></gazebo></xacro:macro>
<xacro:macro name="lidars" params="link topic">
<xacro:lidar link="${link}" topic="${topic}"/></xacro:macro>
<xacro:lidars link="base" topic="/scan"/></robot>"""


@pytest.mark.parametrize(("tag", "count"), [("<topic>${topic}</topic>", 0), ("", 1)])
def test_a_topic_that_a_macro_is_called_with(tmp_path: Path, tag: str, count: int) -> None:
    """It is no topic of other arguments, so it does not excuse a macro that forgets it."""
    files = {"urdf/r.urdf.xacro": CALLED % tag}
    found = reported(tmp_path / "arm", "LAU020", "a.launch.py", BRIDGE % "/scan", files)
    assert [one.help for one in found] == ["write <topic>/scan</topic> into the sensor"] * count


@pytest.mark.parametrize(
    ("package", "help"),
    [
        ("robot_localization", "remove it if robot_localization publishes the transform"),
        ("own", "write /tf_raw"),
    ],
)
def test_a_transform_that_is_kept_from_tf(tmp_path: Path, package: str, help: str) -> None:
    """A car whose drive writes /tf_raw, because a filter publishes the transform."""
    plugin = (
        '<gazebo><plugin filename="gz-sim-diff-drive-system" '
        'name="gz::sim::systems::DiffDrive"><tf_topic>/tf_raw</tf_topic></plugin></gazebo>'
    )
    files = {"r.urdf": f'<robot name="r"><link name="base"/>{plugin}</robot>'}
    text = (
        "nodes = [Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "    parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        f"    Node(package='{package}', executable='ekf_node'),\n"
        "    Node(package='ros_gz_bridge', executable='parameter_bridge',\n"
        "    arguments=['/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V'])]\n"
    )
    (found,) = reported(tmp_path / "arm", "LAU020", "a.launch.py", text, files)
    assert found.help.startswith(help)


@pytest.mark.parametrize(
    ("topic", "count"),
    [("/world/default/dynamic_pose/info", 0), ("/world/default/pose/info", 0), ("/pose", 1)],
)
def test_poses_that_gazebo_publishes(tmp_path: Path, topic: str, count: int) -> None:
    """A car among cones: the truth about all of them, beside the <tf_topic> of its steering."""
    plugin = (
        '<gazebo><plugin filename="gz-sim-ackermann-steering-system" '
        'name="gz::sim::systems::AckermannSteering"/></gazebo>'
    )
    files = {"r.urdf": f'<robot name="r"><link name="base"/>{plugin}</robot>'}
    text = (
        "nodes = [Node(package='robot_state_publisher', executable='robot_state_publisher',\n"
        "    parameters=[{'robot_description': open('../r.urdf').read()}]),\n"
        "    Node(package='ros_gz_bridge', executable='parameter_bridge',\n"
        f"    arguments=['{topic}@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V'])]\n"
    )
    assert len(reported(tmp_path / "arm", "LAU020", "a.launch.py", text, files)) == count


SPAWNED = """\
from launch.actions import ExecuteProcess

ExecuteProcess(cmd=["gz", "sim", "empty.sdf"])
nodes += [Node(package="ros_gz_sim", executable="create", arguments=["-file", %s])]
"""
BARE = '<robot name="r"><link name="base"/></robot>'


@pytest.mark.parametrize(("file", "count"), [('"model.sdf"', 0), ("unknown()", 0), ('"r.urdf"', 1)])
def test_a_robot_that_is_spawned_from_sdf(tmp_path: Path, file: str, count: int) -> None:
    """Its description serves robot_state_publisher alone; the sensors are in the SDF."""
    text = BRIDGE % "/scan" + SPAWNED % file
    found = reported(tmp_path / "arm", "LAU020", "a.launch.py", text, {"urdf/r.urdf.xacro": BARE})
    assert len(found) == count


EXPANDED = """\
import os
from ament_index_python.packages import get_package_share_directory
from launch_ros.actions import Node
from ros_gz_bridge.actions import RosGzBridge

robot = open("../urdf/r.urdf").read()
file = os.path.join(get_package_share_directory("arm"), "config", "b.yaml")
nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher",
         parameters=[{"robot_description": robot}]),
    %s,
]
"""
OF_BOT = """<robot name="r"><link name="base"/><gazebo reference="base">
<sensor name="front" type="gpu_lidar"><topic>bot/scan</topic></sensor></gazebo></robot>"""
ENTRY = """\
- topic_name: scan
  ros_type_name: sensor_msgs/msg/LaserScan
  gz_type_name: gz.msgs.LaserScan
  direction: GZ_TO_ROS
"""


ACTION = 'RosGzBridge(bridge_name="b", namespace="bot", config_file=file%s)'
NODE = 'Node(package="ros_gz_bridge", executable="bridge_node", namespace="bot", parameters=[%s])'
EXPANDING = '{"expand_gz_topic_names": True, "config_file": file}'


@pytest.mark.parametrize(
    ("bridge", "count"),
    [(ACTION % f", extra_bridge_params={EXPANDING}", 0), (NODE % EXPANDING, 0), (ACTION % "", 1)],
)
def test_names_of_gazebo_below_the_namespace_of_the_bridge(
    tmp_path: Path, bridge: str, count: int
) -> None:
    """A waferbot, whose robots share a file of topics."""
    files = {"urdf/r.urdf": OF_BOT, "config/b.yaml": ENTRY}
    found = reported(tmp_path / "arm", "LAU020", "a.launch.py", EXPANDED % bridge, files)
    assert [one.help for one in found] == ["write /bot/scan"] * count
