"""Topics, behaviours, containers and transforms that programs of a launch file share."""

from pathlib import Path

import pytest

from tests.launched import reported

IMPORT = "from launch_ros.actions import Node\n"
NODE = IMPORT + 'nodes = [Node(package="{}", executable="{}"{})]\n'
NAVSAT = ("robot_localization", "navsat_transform_node")
TO_SCAN = ("pointcloud_to_laserscan", "pointcloud_to_laserscan_node")


def messages(directory: Path, code: str, text: str, files: dict[str, str]) -> list[str]:
    return [one.message for one in reported(directory / "arm", code, "a.launch.py", text, files)]


@pytest.mark.parametrize(
    ("program", "more", "count"),
    [
        (NAVSAT, 'remappings=[("imu/data", "/imu")]', 1),
        (NAVSAT, 'remappings=[("imu", "/imu/data"), ("/gps/fix", "/fix")]', 0),
        (NAVSAT, 'remappings=[("/tf", "tf"), ("~/own", "own")]', 0),
        (NAVSAT, 'namespace="a", remappings=[("/imu", "/imu/data")]', 1),
        (NAVSAT, 'namespace="a", remappings=[("imu", "/imu/data")]', 0),
        (TO_SCAN, 'remappings=[("points", "/points")]', 1),
        (("own", "navsat_transform_node"), 'remappings=[("imu/data", "/imu")]', 0),
    ],
)
def test_topics_that_a_node_does_not_have(
    tmp_path: Path, program: tuple[str, str], more: str, count: int
) -> None:
    found = messages(tmp_path, "LAU028", NODE.format(*program, f", {more}"), {})
    assert ["has no effect" in one for one in found] == [True] * count


BEHAVIORS = """behavior_server:
  ros__parameters:
    behavior_plugins: {}
    backup: {{plugin: nav2_behaviors::BackUp}}
    spin: {{plugin: nav2_behaviors::Spin}}
    wait: {{plugin: nav2_behaviors::Wait}}
bt_navigator:
  ros__parameters: {{{}}}
"""
TREE = "default_nav_to_pose_bt_xml: /own.xml"


@pytest.mark.parametrize(
    ("plugins", "tree", "count"),
    [
        ("[spin, backup, wait]", "global_frame: map", 0),
        ("[spin, wait]", "global_frame: map", 1),
        ("[spin, wait]", TREE, 0),
    ],
)
def test_behaviours_of_the_default_tree(
    tmp_path: Path, plugins: str, tree: str, count: int
) -> None:
    text = NODE.format("nav2_behaviors", "behavior_server", ', parameters=["../a.yaml"]')
    yaml = BEHAVIORS.format(plugins, tree)
    found = messages(tmp_path, "LAU040", text, {"a.yaml": yaml})
    assert ["calls 'backup'" in one for one in found] == [True] * count


@pytest.mark.parametrize(("name", "count"), [("GridBased", 0), ("Custom", 1)])
def test_planners_of_the_default_tree(tmp_path: Path, name: str, count: int) -> None:
    yaml = (
        f"planner_server:\n  ros__parameters:\n    planner_plugins: [{name}]\n"
        f"    {name}: {{plugin: nav2_navfn_planner::NavfnPlanner}}\n"
        "bt_navigator:\n  ros__parameters: {global_frame: map}\n"
    )
    text = NODE.format("nav2_planner", "planner_server", ', parameters=["../a.yaml"]')
    found = messages(tmp_path, "LAU040", text, {"a.yaml": yaml})
    assert ["calls 'GridBased'" in one for one in found] == [True] * count


INCLUDE = """from ament_index_python.packages import get_package_share_directory
from launch.actions import IncludeLaunchDescription
from launch.launch_description_sources import PythonLaunchDescriptionSource
from launch_ros.actions import Node

nav2 = IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        get_package_share_directory("nav2_bringup") + "/launch/navigation_launch.py"
    ),
    launch_arguments={{"use_composition": "{}"}}.items(),
)
"""
CONTAINER = """
container = Node(
    package="rclcpp_components", executable="component_container_mt", name="nav2_container"
)
"""


@pytest.mark.parametrize(
    ("composed", "more", "count"), [("True", "", 1), ("False", "", 0), ("True", CONTAINER, 0)]
)
def test_a_container_that_nothing_starts(
    tmp_path: Path, composed: str, more: str, count: int
) -> None:
    found = messages(tmp_path, "LAU030", INCLUDE.format(composed) + more, {})
    assert ["'nav2_container'" in one for one in found] == [True] * count


BRIDGE = NODE.format(
    "ros_gz_bridge", "parameter_bridge", ', parameters=[{"config_file": "../a.yaml"}]'
)


@pytest.mark.parametrize(("dash", "count"), [("- ", 0), ("  ", 1)])
def test_a_bridge_reads_a_list(tmp_path: Path, dash: str, count: int) -> None:
    yaml = f"""{dash}ros_topic_name: /scan
  gz_topic_name: /scan
  ros_type_name: sensor_msgs/msg/LaserScan
  gz_type_name: gz.msgs.LaserScan
"""
    text = BRIDGE.replace("../a.yaml", str(tmp_path / "arm" / "a.yaml"))
    found = messages(tmp_path, "LAU020", text, {"a.yaml": yaml})
    assert ["must be a list" in one for one in found] == [True] * count
    found = messages(tmp_path, "LAU020", text, {"a.yaml": f"bridges:\n- {yaml[2:]}"})
    assert ["must be a list" in one for one in found] == [True]


LUA = """options = {{
  map_frame = "map",
  published_frame = "{}",
  odom_frame = "odom",
  provide_odom_frame = {},
}}
"""
FILTER = """ekf_filter_node:
  ros__parameters: {odom_frame: odom, world_frame: odom, base_link_frame: base_link}
"""
SLAM = (
    IMPORT
    + """nodes = [
    Node(package="robot_localization", executable="ekf_node", name="ekf_filter_node",
         parameters=["../a.yaml"]),
    Node(package="cartographer_ros", executable="cartographer_node",
         arguments=["-configuration_directory", "..", "-configuration_basename", "a.lua"]),
]
"""
)


@pytest.mark.parametrize(
    ("frame", "provided", "count"),
    [("base_link", "true", 1), ("base_link", "false", 1), ("odom", "false", 0)],
)
def test_odometry_of_cartographer(tmp_path: Path, frame: str, provided: str, count: int) -> None:
    files = {"a.yaml": FILTER, "a.lua": LUA.format(frame, provided)}
    found = messages(tmp_path, "LAU021", SLAM.replace('".."', repr(str(tmp_path / "arm"))), files)
    assert ["by 'cartographer_node'" in one for one in found] == [True] * count


def component(package: str, plugin: str, remappings: str) -> str:
    return f"""from launch_ros.actions import ComposableNodeContainer
from launch_ros.descriptions import ComposableNode

container = ComposableNodeContainer(
    package="rclcpp_components", executable="component_container", name="c", namespace="",
    composable_node_descriptions=[
        ComposableNode(package="{package}", plugin="{plugin}", remappings=[{remappings}]),
    ],
)
"""


@pytest.mark.parametrize(("topic", "count"), [("image", 0), ("image_raw", 1)])
def test_topics_of_a_composable_node(tmp_path: Path, topic: str, count: int) -> None:
    text = component("image_proc", "image_proc::RectifyNode", f'("{topic}", "/camera/image")')
    found = messages(tmp_path, "LAU028", text, {})
    assert ["has no effect" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("second", "more", "count"), [("a", "", 1), ("b", "", 0), ("a", ', "-allow_renaming"', 0)]
)
def test_models_of_one_name(tmp_path: Path, second: str, more: str, count: int) -> None:
    spawn = 'Node(package="ros_gz_sim", executable="create", arguments=["-topic", "r", "-name", '
    text = f'{IMPORT}nodes = [{spawn}"a"]), {spawn}"{second}"{more}])]\n'
    found = messages(tmp_path, "LAU043", text, {})
    assert ["has a model 'a' already" in one for one in found] == [True] * count


TWICE = (
    INCLUDE.format("False")
    + """
again = IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        get_package_share_directory("nav2_bringup") + "/launch/FILE"
    ),
    launch_arguments={"params_file": "/nav2.yaml"}.items(),
)
"""
)


@pytest.mark.parametrize(
    ("file", "count"), [("bringup_launch.py", 1), ("localization_launch.py", 0)]
)
def test_servers_that_are_started_twice(tmp_path: Path, file: str, count: int) -> None:
    found = messages(tmp_path, "LAU043", TWICE.replace("FILE", file), {})
    assert ["is started twice" in one for one in found] == [True] * count


@pytest.mark.parametrize(("more", "count"), [("", 1), ('"use_namespace": "True", ', 0)])
def test_a_namespace_that_has_no_effect(tmp_path: Path, more: str, count: int) -> None:
    text = INCLUDE.replace("navigation_launch", "bringup_launch")
    text = text.replace('"use_composition": "{}"', f'{more}"namespace": "robot"')
    found = messages(tmp_path, "LAU005", text.replace("{{", "{").replace("}}", "}"), {})
    assert ["without use_namespace" in one for one in found] == [True] * count


AMCL = """ekf_filter_node:
  ros__parameters: {odom_frame: odom, world_frame: odom, base_link_frame: base_link}
amcl:
  ros__parameters: {odom_frame_id: FRAME}
"""
LOCALIZED = (
    IMPORT
    + """nodes = [
    Node(package="robot_localization", executable="ekf_node", name="ekf_filter_node",
         parameters=["../a.yaml"]),
    Node(package="nav2_amcl", executable="amcl", parameters=["../a.yaml"]),
]
"""
)


@pytest.mark.parametrize(
    ("frame", "more", "count"),
    [
        ("odom", "", 0),
        ("/odom", "", 0),
        ("odom_combined", "", 1),
        ("odom_combined", "other:\n  ros__parameters: {odom_frame_id: odom_combined}\n", 0),
    ],
)
def test_another_frame_of_odometry(tmp_path: Path, frame: str, more: str, count: int) -> None:
    yaml = AMCL.replace("FRAME", frame) + more
    found = messages(tmp_path, "LAU023", LOCALIZED, {"a.yaml": yaml})
    assert ["frame of odometry" in one for one in found] == [True] * count


DRIVE = """drive:
  ros__parameters: {odom_frame_id: odom, MOREwheel_radius: 0.1}
controller_manager:
  ros__parameters: {drive: {type: diff_drive_controller/DiffDriveController}}
"""
OF_BRIDGE = """), Node(
    package="ros_gz_bridge", executable="parameter_bridge",
    arguments=["/tf@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V"]"""
DRIVEN_BY = """nodes += [
    Node(package="controller_manager", executable="spawner", arguments=["drive"]EXTRA),
]
"""


@pytest.mark.parametrize(
    ("frame", "more", "after", "count"),
    [
        ("odom", "", "", 0),
        ("odm", "", "", 1),
        ("/drive/odom", "", "", 1),  # the topic
        ("odm", "enable_odom_tf: false, ", "", 0),
        ("odm", "", ', namespace="a"', 0),
        ("odm", "", '), Node(package="gazebo_ros", executable="spawn_entity.py"', 0),
        ("odm", "", OF_BRIDGE, 0),
    ],
)
def test_another_frame_than_the_one_of_the_drive(
    tmp_path: Path, frame: str, more: str, after: str, count: int
) -> None:
    yaml = AMCL[AMCL.index("amcl:") :].replace("FRAME", frame) + DRIVE.replace("MORE", more)
    text = LOCALIZED.replace("robot_localization", "rviz2").replace("ekf_node", "rviz2")
    text += DRIVEN_BY.replace("EXTRA", after)
    found = messages(tmp_path, "LAU023", text, {"a.yaml": yaml})
    assert ["the wheel controller" in one or "drive" in one for one in found] == [True] * count


DRIVEN = """from launch_ros.actions import Node

nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher",
         parameters=[{"robot_description": open("../r.urdf").read()}]),
    Node(package="PACKAGE", executable="EXECUTABLE", name="lidar"MORE),
    Node(package="nav2_amcl", executable="amcl", name="amcl", parameters=["../a.yaml"]),
]
"""
ROBOT = '<robot name="r"><link name="base_link"/><link name="laser"/></robot>'
AMCL_FILES = {"a.yaml": "amcl:\n  ros__parameters: {scan_topic: scan}\n", "r.urdf": ROBOT}
RPLIDAR = ("rplidar_ros", "rplidar_node")


@pytest.mark.parametrize(
    ("program", "more", "topic"),
    [
        (RPLIDAR, "", ""),
        (RPLIDAR, ', remappings=[("scan", "/lidar/scan")]', "/lidar/scan"),
        (("ldlidar_node", "ldlidar_node"), "", "/lidar/scan"),
        (("ldlidar_node", "ldlidar_node"), ', remappings=[("~/scan", "/scan")]', ""),
        (("own_driver", "own_driver"), "", ""),
    ],
)
def test_drivers_that_are_not_installed(
    tmp_path: Path, program: tuple[str, str], more: str, topic: str
) -> None:
    text = DRIVEN.replace("PACKAGE", program[0]).replace("EXECUTABLE", program[1])
    found = messages(tmp_path, "LAU032", text.replace("MORE", more), AMCL_FILES)
    found = [one for one in found if "unconfigured" not in one]
    assert [f"are on '{topic}'" in one for one in found] == [True] * bool(topic)


TO_CLOUD = ("pointcloud_to_laserscan", "pointcloud_to_laserscan_node")


@pytest.mark.parametrize(
    ("program", "given", "words"),
    [
        (TO_CLOUD, '"target_frame": "cloud"', "'cloud' is neither"),
        (TO_CLOUD, '"target_frame": "base_link"', ""),
        (TO_CLOUD, '"min_height": 0.0', ""),
        (("explore_lite", "explore"), '"robot_base_frame": "x"', "'x' is neither"),
        (("explore_lite", "explore"), "", ""),
        (("bno055", "bno055"), "", "'bno055' is neither"),
        (("bno055", "bno055"), '"frame_id": "laser"', ""),
    ],
)
def test_frames_of_programs(
    tmp_path: Path, program: tuple[str, str], given: str, words: str
) -> None:
    text = DRIVEN.replace("PACKAGE", program[0]).replace("EXECUTABLE", program[1])
    text = text.replace("MORE", f", parameters=[{{{given}}}]")
    files = {**AMCL_FILES, "a.yaml": "amcl:\n  ros__parameters: {base_frame_id: base_link}\n"}
    found = messages(tmp_path, "LAU023", text, files)
    assert [words in one for one in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("world", "more", "count"),
    [
        ("odom", "", 1),
        ("map", "", 0),
        ("odom", '"publish_tf": False', 0),
        ("odom", '}], remappings=[("/tf", "tf")], namespace="b", ros_arguments=[*{"a": 1', 0),
    ],
)
def test_two_filters_of_one_transform(tmp_path: Path, world: str, more: str, count: int) -> None:
    first = 'Node(package="robot_localization", executable="ekf_node", name="{}", parameters=[{}])'
    local = first.format("local", '{"world_frame": "odom", "odom0": "odom"}')
    second = first.format("other", f'{{"world_frame": "{world}", "odom0": "gps", {more}}}')
    found = messages(tmp_path, "LAU021", f"{IMPORT}nodes = [{local}, {second}]\n", {})
    words = "the transform of 'odom' is published twice: by 'other', and by 'local'"
    assert [words == one for one in found if "transform" in one] == [True] * count


@pytest.mark.parametrize(("low", "count"), [(0.0, 0), (1.0, 1)])
def test_bounds_in_a_launch_file(tmp_path: Path, low: float, count: int) -> None:
    given = f', parameters=[{{"min_height": {low}, "max_height": 0.5}}]'
    found = messages(tmp_path, "LAU026", NODE.format(*TO_CLOUD, given), {})
    assert ["above max_height" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("spawn", "more", "count"),
    [
        ('Node(package="ros_gz_sim", executable="create"),', "", 1),
        ('Node(package="ros_gz_sim", executable="create"),', '{"use_sim_time": True}', 0),
        ("", "", 0),
    ],
)
def test_sliders_in_a_simulation(tmp_path: Path, spawn: str, more: str, count: int) -> None:
    program = 'package="joint_state_publisher", executable="joint_state_publisher"'
    other = 'Node(package="rviz2", executable="rviz2", parameters=[{"use_sim_time": True}])'
    text = f"{IMPORT}nodes = [{spawn} {other}, Node({program}, parameters=[{more}])]\n"
    found = messages(tmp_path, "LAU031", text, {})
    assert sum("joint_state_publisher lacks use_sim_time" in one for one in found) == count


@pytest.mark.parametrize(
    ("condition", "count"), [("Unless", 0), ("If", 1)], ids=["other choice", "same choice"]
)
def test_servers_in_timers_of_two_choices(tmp_path: Path, condition: str, count: int) -> None:
    """siddharthtiwari1/wheelchair_nav: each timer has a condition, the node in it has none."""
    node = 'Node(package="nav2_amcl", executable="amcl", name="amcl")'
    timer = f"TimerAction(period=1.0, actions=[{node}], condition={{}}Condition(choice))"
    text = (
        f'{IMPORT}choice = LaunchConfiguration("choice", default="true")\n'
        f"first = {timer.format('If')}\nsecond = {timer.format(condition)}\n"
    )
    found = messages(tmp_path, "LAU043", text, {})
    assert ["is started twice" in one for one in found] == [True] * count


GIVEN = """
nodes += [
    Node(package="ros_gz_bridge", executable="parameter_bridge",
         arguments=["/imu/data@sensor_msgs/msg/Imu[gz.msgs.IMU"]),
]
"""


@pytest.mark.parametrize(
    ("more", "count"),
    [
        ("", 1),
        (', remappings=[("imu", "/imu/data")]', 0),
        (', parameters=[{"use_odometry_yaw": False, "wait_for_datum": False}]', 1),
        (', parameters=[{"use_odometry_yaw": True}]', 0),
        (', parameters=[{"wait_for_datum": True}]', 0),
    ],
)
def test_the_imu_of_navsat_transform(tmp_path: Path, more: str, count: int) -> None:
    found = messages(tmp_path, "LAU032", NODE.format(*NAVSAT, more) + GIVEN, {})
    assert ["'/imu'" in one for one in found] == [True] * count
