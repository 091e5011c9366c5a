"""LAU021: see the rule."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from urdfkit.text.diagnostic import Diagnostic, Severity

ROBOT = """<robot name="r"><link name="base"/><link name="lidar"/>
<joint name="mast" type="fixed"><parent link="base"/><child link="lidar"/>
<origin xyz="0 0 1"/></joint></robot>"""
STATE = "Node(package='robot_state_publisher', executable='robot_state_publisher')\n"
STATIC = "Node(package='tf2_ros', executable='static_transform_publisher', arguments={})\n"
GUI = "Node(package='joint_state_publisher_gui', executable='joint_state_publisher_gui'{})\n"
SPAWNER = "Node(package='controller_manager', executable='spawner', arguments={}{})\n"
CONTROLLERS = """
controller_manager:
  ros__parameters:
    a: {type: joint_trajectory_controller/JointTrajectoryController}
    b: {type: velocity_controllers/JointGroupVelocityController}
    c: {type: position_controllers/JointGroupPositionController}
a: {ros__parameters: {joints: [j1, j2], command_interfaces: [position]}}
b: {ros__parameters: {joints: [j2]}}
c: {ros__parameters: {joints: [j2]}}
"""


def messages(directory: Path, text: str) -> list[str]:
    """Messages for a launch file with a robot and controllers."""
    return [one.message for one in found_in(directory, text)]


def found_in(directory: Path, text: str) -> list[Diagnostic]:
    robot = f"open('{directory}/r.urdf')\n"
    manager = "Node(package='controller_manager', executable='ros2_control_node', "
    manager += f"parameters=['{directory}/c.yaml'])\n"
    files = {"r.urdf": ROBOT, "c.yaml": CONTROLLERS}
    return reported(directory, "LAU021", "a.launch.py", robot + manager + text, files)


@pytest.mark.parametrize(
    ("words", "severity"),
    [
        ("'0 0 1 0 0 0 base lidar'.split()", Severity.INFO),
        ("['0', '0', '2', '0', '0', '0', 'base', 'lidar']", Severity.WARNING),
        ("['0', '0', '1', '0', '0', '0', 'map', '/lidar']", Severity.WARNING),
        ("['--frame-id', 'base', '--child-frame-id', 'lidar']", Severity.WARNING),
        ("['--z', '1', '--frame-id', 'base', '--child-frame-id', 'lidar']", Severity.INFO),
        ("['0', '0', '1', '0', '0', '0', 'base', 'lidar']", Severity.INFO),
        ("['0', '0', '0', '0', '0', '0', 'map', 'base']", None),
        ("['0', '0', '0', '0', '0', '0', 'map']", None),
    ],
)
def test_static_transforms(tmp_path: Path, words: str, severity: Severity | None) -> None:
    """Whichever of two equal transforms is used, the link is in the same place."""
    found = found_in(tmp_path, STATE + STATIC.format(words))
    assert [one.severity for one in found] == ([severity] if severity else [])
    assert all("'lidar' is published" in one.message and "'mast'" in one.message for one in found)


NAMED_FILTER = (
    "Node(package='robot_localization', executable='{}', name='{}', "
    "remappings=[('odometry/filtered', '{}')])\n"
)


@pytest.mark.parametrize(
    ("executable", "topic", "count"),
    [("ekf_node", "a", 1), ("ekf_node", "b", 0), ("ukf_node", "/a", 1)],
)
def test_two_filters(tmp_path: Path, executable: str, topic: str, count: int) -> None:
    text = NAMED_FILTER.format("ekf_node", "first", "a") + NAMED_FILTER.format(
        executable, "second", topic
    )
    found = messages(tmp_path, text)
    assert ["publish on '/a'" in one for one in found] == [True] * count


LOCALIZER = "Node(package='nav2_amcl', executable='amcl', parameters=[{}])\n"
TO_ODOM = "['--frame-id', 'map', '--child-frame-id', '{}']"


@pytest.mark.parametrize(
    ("parameters", "child", "count"),
    [
        ("", "odom", 1),
        ("", "other", 0),
        ("{'odom_frame_id': 'other'}", "other", 1),
        ("{'tf_broadcast': False}", "odom", 0),
    ],
)
def test_localization_and_a_static_transform(
    tmp_path: Path, parameters: str, child: str, count: int
) -> None:
    text = LOCALIZER.format(parameters) + STATIC.format(TO_ODOM.format(child))
    found = messages(tmp_path, text)
    assert [f"'{child}' is published" in one for one in found] == [True] * count


@pytest.mark.parametrize(
    ("package", "words", "count"),
    [
        ("nav2_amcl", "['--frame-id', 'base', '--child-frame-id', 'lidar']", 1),
        ("nav2_amcl", "['--z', '1', '--frame-id', 'base', '--child-frame-id', 'lidar']", 1),
        ("my_driver", "['--frame-id', 'base', '--child-frame-id', 'lidar']", 0),
    ],
)
def test_a_robot_of_another_launch_file(
    tmp_path: Path, package: str, words: str, count: int
) -> None:
    """Navigation needs the transforms of the robot; a driver may run without it."""
    files = {"r.urdf": ROBOT}
    files["launch/robot.launch.py"] = f"robot = open('{tmp_path}/r.urdf')\n" + STATE
    node = f"Node(package='{package}', executable='amcl')\n"
    found = reported(tmp_path, "LAU021", "a.launch.py", node + STATIC.format(words), files)
    assert ["'lidar' is published" in one.message for one in found] == [True] * count


SIMULATION = (
    "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 'robot_description'])\n"
)


@pytest.mark.parametrize(
    ("others", "parameters", "count"),
    [
        ([SIMULATION], "", 0),
        ([SIMULATION], "{'use_sim_time': True}", 1),
        ([SIMULATION], "{'use_sim_time': False}", 0),
        ([SIMULATION, ""], "", 1),
    ],
)
def test_a_robot_of_a_simulation_alone(
    tmp_path: Path, others: list[str], parameters: str, count: int
) -> None:
    """Symovo's navigation runs on the real robot, whose driver publishes nothing of the lidar."""
    files = {"r.urdf": ROBOT}
    for number, other in enumerate(others):
        text = f"robot = open('{tmp_path}/r.urdf')\n{STATE}{other}"
        files[f"launch/robot{number}.launch.py"] = text
    node = f"Node(package='nav2_amcl', executable='amcl', parameters=[{parameters}])\n"
    words = "['--frame-id', 'base', '--child-frame-id', 'lidar']"
    found = reported(tmp_path, "LAU021", "a.launch.py", node + STATIC.format(words), files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("others", "count"),
    [
        (["Node(package='rviz2', executable='rviz2')\n"], 0),
        ([""], 1),
        (["Node(package='rviz2', executable='rviz2')\n", ""], 1),
        (["Node(package='rviz2', executable='rviz2')\nNode(package='base', executable='b')\n"], 1),
    ],
)
def test_a_robot_that_is_only_displayed(tmp_path: Path, others: list[str], count: int) -> None:
    """agrobot: its navigation has static transforms, and a launch file shows the model in RViz."""
    files = {"r.urdf": ROBOT}
    for number, other in enumerate(others):
        text = f"robot = open('{tmp_path}/r.urdf')\n{STATE}{other}"
        files[f"launch/robot{number}.launch.py"] = text
    node = "Node(package='nav2_amcl', executable='amcl')\n"
    words = "['--frame-id', 'base', '--child-frame-id', 'lidar']"
    found = reported(tmp_path, "LAU021", "a.launch.py", node + STATIC.format(words), files)
    assert len(found) == count


def test_without_a_robot_state_publisher_nothing_is_published_twice(tmp_path: Path) -> None:
    words = "['0', '0', '2', '0', '0', '0', 'base', 'lidar']"
    assert messages(tmp_path, STATIC.format(words)) == []


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (GUI.format("") + SPAWNER.format("['joint_state_broadcaster']", ""), 1),
        (GUI.format("") + SPAWNER.format("['arm']", ""), 0),
        (GUI.format("") + SPAWNER.format("['joint_state_broadcaster', '--inactive']", ""), 0),
        (
            GUI.format(", condition=IfCondition(LaunchConfiguration('gui'))")
            + SPAWNER.format("['joint_state_broadcaster']", ""),
            0,
        ),
        (
            f"if shows():\n    {GUI.format('')}"
            + SPAWNER.format("['joint_state_broadcaster']", ""),
            0,
        ),
        (
            GUI.format(", remappings=[('joint_states', 'wanted')]")
            + SPAWNER.format("['joint_state_broadcaster']", ""),
            0,
        ),
        (
            GUI.format(", parameters=[{'source_list': ['a']}]")
            + SPAWNER.format("['joint_state_broadcaster']", ""),
            0,
        ),
        (GUI.format("") + GUI.format("").replace("_gui", ""), 1),
        (GUI.format("").replace("_gui", ""), 0),
        (GUI.format(", namespace='arm'") + GUI.format("").replace("_gui", ""), 0),
        (GUI.format("") + SPAWNER.format("['joint_state_broadcaster']", ", namespace='arm'"), 0),
        (GUI.format("") + SPAWNER.format("['joint_state_broadcaster', '-c', '/arm/cm']", ""), 0),
        (
            GUI.format(", namespace='arm'")
            + SPAWNER.format("['joint_state_broadcaster', '-c', '/arm/cm']", ""),
            1,
        ),
    ],
)
def test_joint_states(tmp_path: Path, text: str, count: int) -> None:
    assert len(messages(tmp_path, text)) == count


DRIVE = """
<gazebo><plugin filename="gz-sim-diff-drive-system" name="drive"><frame_id>odom</frame_id>
<child_frame_id>{}</child_frame_id></plugin></gazebo></robot>"""
BRIDGE = (
    "Node(package='ros_gz_bridge', executable='parameter_bridge', "
    "arguments=['{}@tf2_msgs/msg/TFMessage[gz.msgs.Pose_V'])\n"
)
EKF = "Node(package='robot_localization', executable='ekf_node', parameters=['{}/ekf.yaml'])\n"
FILTER = (
    "ekf_filter_node: {{ros__parameters: {{odom_frame: odom, world_frame: odom, "
    "base_link_frame: base, publish_tf: {}}}}}\n"
)


@pytest.mark.parametrize(
    ("base", "topic", "filter", "words"),
    [
        ("base", "/tf", "", ""),
        ("lidar", "/tf", "", "joint 'mast'"),
        ("lidar", "/model/r/pose", "", ""),
        ("base", "/tf", "true", "is published twice"),
        ("base", "/tf", "false", ""),
        ("base", "/other", "true", ""),
    ],
)
def test_odometry_of_gazebo(tmp_path: Path, base: str, topic: str, filter: str, words: str) -> None:
    plugin = DRIVE.replace("<frame_id>", "<tf_topic>tf</tf_topic><frame_id>").format(base)
    robot = f"open('{tmp_path}/r.urdf')\n"
    bridge = BRIDGE.format(topic)
    text = robot + STATE + bridge + (EKF.format(tmp_path) if filter else "")
    files = {
        "r.urdf": ROBOT.replace("</robot>", plugin),
        "ekf.yaml": FILTER.format(filter or "true"),
    }
    found = reported(tmp_path, "LAU021", "a.launch.py", text, files)
    assert [words in finding.message for finding in found] == [True] * bool(words)


@pytest.mark.parametrize(
    ("world", "published", "localizer", "count"),
    [
        ("map", "true", LOCALIZER.format(""), 1),
        ("odom", "true", LOCALIZER.format(""), 0),
        ("map", "false", LOCALIZER.format(""), 0),
        ("map", "true", LOCALIZER.format("{'odom_frame_id': 'other'}"), 0),
        ("map", "true", LOCALIZER.format("{'tf_broadcast': False}"), 0),
        ("map", "true", "", 0),
    ],
)
def test_a_filter_that_localizes(
    tmp_path: Path, world: str, published: str, localizer: str, count: int
) -> None:
    """From MonashNovaRover/nova#788."""
    yaml = FILTER.format(published).replace("world_frame: odom", f"world_frame: {world}")
    text = EKF.format(tmp_path) + localizer
    found = reported(tmp_path, "LAU021", "a.launch.py", text, {"ekf.yaml": yaml})
    assert ["from map to odom" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("second", "count"), [("one", 1), ("other", 0)])
def test_filters_whose_parameters_are_of_all_nodes(tmp_path: Path, second: str, count: int) -> None:
    """``/**`` in a file for each robot."""
    node = "Node(package='robot_localization', executable='ekf_node', parameters=['{}/{}.yaml'])\n"
    filters = "".join(node.format(tmp_path, name) for name in ("one", second))
    files = {
        f"{name}.yaml": FILTER.format("true")
        .replace("ekf_filter_node", "/**")
        .replace("odom,", f"{name}_odom,")
        for name in ("one", "other")
    }
    found = reported(tmp_path, "LAU021", "a.launch.py", filters, files)
    assert sum("'one_odom' is published twice" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("topic", "remapping", "count"),
    [
        ("/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model", "", 1),
        ("/arm/states@sensor_msgs/msg/JointState[gz.msgs.Model", "", 0),
        ("/joint_states@sensor_msgs/msg/JointState]gz.msgs.Model", "", 0),
        (
            "/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model",
            ", remappings=[('joint_states', 'wanted_joint_states')]",
            0,
        ),
        (
            "/arm/states@sensor_msgs/msg/JointState[gz.msgs.Model",
            ", remappings=[('joint_states', '/arm/states')]",
            1,
        ),
    ],
)
def test_joint_states_of_the_bridge(tmp_path: Path, topic: str, remapping: str, count: int) -> None:
    bridge = "Node(package='ros_gz_bridge', executable='parameter_bridge', "
    bridge += f"arguments=[{topic!r}])\n"
    text = f"open('{tmp_path}/r.urdf')\n{bridge}{GUI.format(remapping)}"
    publisher = '<gazebo><plugin filename="gz-sim-joint-state-publisher-system" name="p"><topic>'
    publisher += f"{topic.partition('@')[0]}</topic></plugin></gazebo></robot>"
    files = {"r.urdf": ROBOT.replace("</robot>", publisher)}
    found = [one.message for one in reported(tmp_path, "LAU021", "a.launch.py", text, files)]
    assert found == [naming("joint_state_publisher_gui", "bridge")] * count
    files, count = {"r.urdf": ROBOT}, 0  # nothing in Gazebo publishes the topic
    assert len(reported(tmp_path, "LAU021", "a.launch.py", text, files)) == count


SLAM = """IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        get_package_share_directory('slam_toolbox') + '/launch/{}_launch.py'
    ),
    launch_arguments={{'slam_params_file': '{}/c.yaml'}}.items(),
)
"""
AMCL = "Node(package='nav2_amcl', executable='amcl'{})\n"
NAV2 = "IncludeLaunchDescription(get_package_share_directory('nav2_bringup') + '/launch/{}')\n"


@pytest.mark.parametrize(
    ("slam", "other", "count"),
    [
        ("online_async", AMCL.format(""), 1),
        ("online_async", "", 0),
        ("other", AMCL.format(""), 0),
        ("online_sync", AMCL.format(", parameters=[{'tf_broadcast': False}]"), 0),
        ("online_sync", AMCL.format(", parameters=[{'tf_broadcast': True}]"), 1),
        ("online_sync", AMCL.format(", namespace='other'"), 0),
        ("online_sync", AMCL.format(", condition=IfCondition(LaunchConfiguration('x'))"), 0),
        ("online_sync", NAV2.format("localization_launch.py"), 1),
        ("online_sync", NAV2.format("bringup_launch.py"), 1),
        ("online_sync", NAV2.format("navigation_launch.py"), 0),
    ],
)
def test_two_programs_that_localize(tmp_path: Path, slam: str, other: str, count: int) -> None:
    found = messages(tmp_path, SLAM.format(slam, tmp_path) + other)
    assert len(found) == count
    assert all("map to odom" in one for one in found)


def test_nav2_with_its_slam(tmp_path: Path) -> None:
    nav2 = NAV2.format("bringup_launch.py")[:-2]
    text = f"{nav2}, launch_arguments={{'slam': 'True'}}.items())\n"
    assert messages(tmp_path, SLAM.format("online_sync", tmp_path) + text) == []


MOVED = """
controller_manager:
  ros__parameters:
    drive: {{type: diff_drive_controller/DiffDriveController}}
drive: {{ros__parameters: {{{}}}}}
"""


@pytest.mark.parametrize(
    ("parameters", "parent", "child", "help"),
    [
        ("base_frame_id: base", "map", "base", naming("map", "odom")),
        ("base_frame_id: base", "odom", "/base", naming("static_transform_publisher")),
        ("base_frame_id: base, odom_frame_id: o", "map", "base", naming("map to o")),
        (
            "base_frame_id: base",
            "base_footprint",
            "base",
            "let controller 'drive' publish odom -> base_footprint",
        ),
        ("base_frame_id: base, enable_odom_tf: false", "map", "base", ""),
        ("base_frame_id: base", "map", "odom", ""),
        ("", "map", "base_link", naming("map", "odom")),
    ],
)
def test_odometry_and_a_static_transform(
    tmp_path: Path, parameters: str, parent: str, child: str, help: str
) -> None:
    start = (
        "Node(package='controller_manager', executable='ros2_control_node', "
        f"parameters=['{tmp_path}/c.yaml'])\n"
    )
    words = ["--frame-id", parent, "--child-frame-id", child]
    text = start + SPAWNER.format(["drive"], "") + STATIC.format(words)
    files = {"c.yaml": MOVED.format(parameters)}
    found = reported(tmp_path, "LAU021", "a.launch.py", text, files)
    assert [one.help for one in found] == [help] * bool(help)
    assert all("controller 'drive'" in one.message for one in found)


@pytest.mark.parametrize(
    ("drive", "parameters", "count"),
    [
        ("omni_wheel_drive_controller/OmniWheelDriveController", "", 1),
        ("tricycle_controller/TricycleController", "", 0),
        ("tricycle_controller/TricycleController", "enable_odom_tf: true", 1),
        ("mecanum_drive_controller/MecanumDriveController", "enable_odom_tf: true", 0),  # own topic
    ],
)
def test_drives_that_publish_the_transform(
    tmp_path: Path, drive: str, parameters: str, count: int
) -> None:
    start = (
        "Node(package='controller_manager', executable='ros2_control_node', "
        f"parameters=['{tmp_path}/c.yaml'])\n"
    )
    words = ["--frame-id", "odom", "--child-frame-id", "base_link"]
    text = start + SPAWNER.format(["drive"], "") + STATIC.format(words)
    moved = MOVED.format(parameters).replace("diff_drive_controller/DiffDriveController", drive)
    found = reported(tmp_path, "LAU021", "a.launch.py", text, {"c.yaml": moved})
    assert ["controller 'drive'" in one.message for one in found] == [True] * count
