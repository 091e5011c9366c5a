"""LAU022: see the rule."""

from pathlib import Path

import pytest

from tests.jointed import joint, robot
from tests.launched import reported
from tests.naming import naming, values
from urdfkit import Diagnostic

STATE = "Node(package='robot_state_publisher', executable='robot_state_publisher'{})\n"
NODE = "Node(package='{}', executable='{}', {})\n"
SPAWNER = NODE.format("controller_manager", "spawner", "arguments={}")
CONTROLLERS = """
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
"""


def messages(directory: Path, text: str) -> list[str]:
    manager = f"parameters=['{directory}/c.yaml']"
    start = NODE.format("controller_manager", "ros2_control_node", manager)
    found = reported(directory, "LAU022", "a.launch.py", start + text, {"c.yaml": CONTROLLERS})
    return [one.message for one in found]


def of_topics(directory: Path, text: str, files: dict[str, str]) -> list[Diagnostic]:
    """What is said of a launch file without lifecycle manager, except that it has none."""
    found = reported(directory, "LAU022", "a.launch.py", text, files)
    return [one for one in found if "lifecycle manager" not in one.message]


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (STATE.format("") + SPAWNER.format(["arm"]), 1),
        (STATE.format("") + SPAWNER.format(["states", "arm"]), 0),
        (STATE.format("") + SPAWNER.format(["arm"]) + SPAWNER.format(["states"]), 0),
        (STATE.format("") + SPAWNER.format(["other"]), 0),  # unknown type
        (SPAWNER.format(["arm"]), 0),
        (STATE.format(""), 0),
        (
            STATE.format("")
            + SPAWNER.format(["arm"])
            + NODE.format("joint_state_publisher", "joint_state_publisher", ""),
            0,
        ),
        (
            STATE.format("")
            + SPAWNER.format(["arm"])
            + NODE.format(
                "ros_gz_bridge",
                "parameter_bridge",
                "arguments=['/j@sensor_msgs/msg/JointState[gz.msgs.Model']",
            ),
            0,
        ),
        (STATE.format("") + SPAWNER.format(["arm"]) + "IncludeLaunchDescription(x)\n", 1),
        (
            STATE.format(", condition=IfCondition(LaunchConfiguration('x'))")
            + SPAWNER.format(["arm"]),
            0,
        ),
    ],
)
def test_joint_states(tmp_path: Path, text: str, count: int) -> None:
    found = messages(tmp_path, text)
    assert len(found) == count
    assert all("joint states" in one for one in found)


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("continuous", 1)])
def test_joint_states_of_a_sensor(tmp_path: Path, kind: str, count: int) -> None:
    """rq_fts_ros2_driver: the force-torque sensor has no joint that moves."""
    sensor = robot(joint("measuring", kind))
    (tmp_path / "ft.urdf").write_text(f'<robot name="ft">{sensor}</robot>')
    described = f", parameters=[{{'robot_description': Command(['xacro {tmp_path}/ft.urdf'])}}]"
    assert len(messages(tmp_path, STATE.format(described) + SPAWNER.format(["arm"]))) == count


@pytest.mark.parametrize(
    ("parameters", "count"),
    [
        (", parameters=[{'robot_description': x}]", 1),
        (", parameters=[{'robot_description': x, 'use_sim_time': True}]", 0),
        (", parameters=[unknown]", 0),
    ],
)
def test_clocks(tmp_path: Path, parameters: str, count: int) -> None:
    other = NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    bridge = NODE.format(
        "ros_gz_bridge",
        "parameter_bridge",
        "arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock']",
    )
    assert len(messages(tmp_path, STATE.format(parameters) + other + spawn + bridge)) == count
    assert messages(tmp_path, STATE.format(parameters) + other) == []


GAZEBO = """IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        os.path.join(get_package_share_directory("ros_gz_sim"), "launch", "gz_sim.launch.py")
    ),
    launch_arguments={"gz_args": "-r empty.sdf"}.items(),
)
"""


@pytest.mark.parametrize(
    ("words", "more", "count"),
    [
        # BILLEE: the remapping is in the command line
        (", '--ros-args', '-r', '/world/w/clock:=/clock'", "", 0),
        (", '--ros-args', '--remap', 'bridge:/world/w/clock:=/clock'", "", 0),
        (", '--ros-args', '-r', unknown", "", 0),
        ("", ", ros_arguments=['-r', '/world/w/clock:=/clock']", 0),
        (", '--ros-args', '-r', '__ns:=/bot'", "", 1),
        ("", "", 1),
    ],
)
def test_a_clock_that_is_remapped(tmp_path: Path, words: str, more: str, count: int) -> None:
    state = STATE.format(", parameters=[{'robot_description': x, 'use_sim_time': True}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    topic = "'/world/w/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'"
    bridge = NODE.format("ros_gz_bridge", "parameter_bridge", f"arguments=[{topic}{words}]{more}")
    found = messages(tmp_path, state + spawn + bridge + GAZEBO)
    assert len([one for one in found if "/clock" in one]) == count


BRIDGE = NODE.format(
    "ros_gz_bridge", "parameter_bridge", "arguments=['{}@sensor_msgs/msg/Imu[gz.msgs.IMU'{}]"
)
FILTER = NODE.format("robot_localization", "ekf_node", "parameters=['../ekf.yaml']{}")
EKF = "ekf_filter_node:\n  ros__parameters:\n    imu0: imu\n    imu0_config: []\n"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (BRIDGE.format("/imu", "") + FILTER.format(""), 0),
        (BRIDGE.format("/imu/data", "") + FILTER.format(""), 1),
        (FILTER.format(""), 0),  # its publisher is unknown
        (BRIDGE.format("/imu/data", "") + FILTER.format("") + NODE.format("a", "driver", ""), 0),
        (BRIDGE.format("/imu/data", "") + FILTER.format(", remappings=[('imu', 'imu/data')]"), 0),
        (BRIDGE.format("/imu/data", "") + FILTER.format(", namespace='robot'"), 0),
        (
            BRIDGE.format("/imu/data", "")
            + FILTER.format(", remappings=[('odometry/filtered', '/odom')]"),
            1,
        ),
    ],
)
def test_topics(tmp_path: Path, text: str, count: int) -> None:
    found = reported(tmp_path, "LAU022", "a.launch.py", text, {"ekf.yaml": EKF})
    assert len([one for one in found if "waits for '/imu'" in one.message]) == count


ROLLER = """<robot name="r"><link name="a"/><link name="b"/>
<joint name="roll" type="{}"><parent link="a"/><child link="b"/></joint>
<gazebo><plugin filename="gz-sim-{}-system" name="p"/></gazebo></robot>"""
SHOWN = (
    STATE.format(", parameters=[{'robot_description': open('../r.urdf').read()}]")
    + NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    + NODE.format("rviz2", "rviz2", "")
)
JOINTS = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['/clock@rosgraph_msgs/msg/Clock[gz.msgs.Clock'{}]",
)


@pytest.mark.parametrize(
    ("kind", "system", "more", "help"),
    [
        ("continuous", "diff-drive", JOINTS.format(""), "add gz-sim-joint-state-publisher-system"),
        ("continuous", "joint-state-publisher", JOINTS.format(""), "bridge its topic"),
        ("continuous", "pose-publisher", JOINTS.format(""), ""),
        ("fixed", "diff-drive", JOINTS.format(""), ""),
        ("continuous", "diff-drive", "", ""),  # the bridge is started elsewhere
        ("continuous", "diff-drive", JOINTS.format("") + NODE.format("arm", "states", ""), ""),
        (
            "continuous",
            "joint-state-publisher",
            JOINTS.format(", '/joint_states@sensor_msgs/msg/JointState[gz.msgs.Model'"),
            "",
        ),
    ],
)
def test_joint_states_of_gazebo(
    tmp_path: Path, kind: str, system: str, more: str, help: str
) -> None:
    files = {"r.urdf": ROLLER.format(kind, system)}
    found = reported(tmp_path, "LAU022", "a.launch.py", SHOWN + more, files)
    assert [one.help.startswith(help) for one in found] == [True] * bool(help)
    assert all("of roll" in one.message for one in found)


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
    found = reported(tmp_path, "LAU022", "a.launch.py", text)
    expected = ["async_slam_toolbox_node", "/scan"]
    assert [values(one.message)[:2] for one in found] == [expected] * count


@pytest.mark.parametrize(
    ("value", "words"), [("False", "is false, but"), ("True", ""), (None, "lacks use_sim_time")]
)
def test_a_node_without_simulation_time(tmp_path: Path, value: str | None, words: str) -> None:
    own = f", parameters=[{{'use_sim_time': {value}}}]" if value else ", parameters=[{}]"
    text = (
        NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("ros_gz_sim", "create", "arguments=['-string', '<robot/>']")
        + STATE.format(own)
    )
    found = [one for one in messages(tmp_path, text) if "use_sim_time" in one]
    assert len(found) == bool(words)
    assert all(words in one for one in found)


@pytest.mark.parametrize(
    ("publisher", "spawner", "count"),
    [
        ("", "", 0),
        (", remappings=[('/tf', 'tf')]", "", 0),
        (", remappings=[('robot_description', 'arm_description')]", "", 1),
        (", remappings=[('/robot_description', '/arm_description')]", "", 1),
        (", remappings=[(x, 'arm_description')]", "", 0),
        (
            ", remappings=[('robot_description', 'arm_description')]",
            ", remappings=[('robot_description', '/arm_description')]",
            0,
        ),
    ],
)
def test_a_description_with_another_name(
    tmp_path: Path, publisher: str, spawner: str, count: int
) -> None:
    create = f"arguments=['-topic', 'robot_description']{spawner}"
    text = STATE.format(publisher) + NODE.format("ros_gz_sim", "create", create)
    found = [one for one in messages(tmp_path, text) if "robot_description" in one]
    expected = naming("/robot_description", "robot_state_publisher", "/arm_description")
    assert found == [expected] * count


MUX = NODE.format("twist_mux", "twist_mux", "{}")
TELEOP = NODE.format("teleop_twist_joy", "teleop_node", "{}")
COMMANDS = NODE.format(
    "ros_gz_bridge",
    "parameter_bridge",
    "arguments=['/drive/cmd_vel@geometry_msgs/msg/Twist]gz.msgs.Twist']",
)


@pytest.mark.parametrize(
    ("text", "topic"),
    [
        (MUX.format("") + COMMANDS, "/cmd_vel_out"),
        (MUX.format("remappings=[('/cmd_vel_out', '/drive/cmd_vel')]") + COMMANDS, ""),
        (MUX.format("remappings=[('cmd_vel_out', x)]") + COMMANDS, ""),
        (MUX.format("") + COMMANDS.replace("]gz", "[gz"), ""),  # nothing reads any
        (MUX.format("") + COMMANDS + NODE.format("arm", "driver", ""), ""),
        (TELEOP.format("") + COMMANDS, "/cmd_vel"),
        (TELEOP.format("namespace='drive'") + COMMANDS, ""),
        (TELEOP.format("") + COMMANDS + NODE.format("nav2_velocity_smoother", "x", ""), ""),
        (TELEOP.format("parameters=['{}/mux.yaml']") + COMMANDS, ""),
    ],
)
def test_velocity_commands(tmp_path: Path, text: str, topic: str) -> None:
    files = {"mux.yaml": "mux: {ros__parameters: {topics: {joy: {topic: cmd_vel}}}}\n"}
    text = text.replace("{}", str(tmp_path))
    found = [one.message for one in reported(tmp_path, "LAU022", "a.launch.py", text, files)]
    assert [one.split("'")[3] for one in found] == [topic] * bool(topic)
    assert all("read on '/drive/cmd_vel'" in one for one in found)


@pytest.mark.parametrize(
    ("parameters", "own", "stamped", "reported_words"),
    [
        ("", "cmd_vel", "False", "velocity commands"),
        ("", "/drive/cmd_vel", "False", "'/drive/cmd_vel', where TwistStamped"),
        ("", "/drive/cmd_vel", "True", ""),
        ("", "/drive/cmd_vel", "unknown", ""),
        ("use_stamped_vel: false", "/drive/cmd_vel_unstamped", "False", ""),
        ("use_stamped_vel: false", "/drive/cmd_vel_unstamped", "True", "where Twist is"),
        ("use_stamped_vel: false", "/drive/cmd_vel", "False", "where TwistStamped"),
        ("use_stamped_vel: false", "/cmd_vel", "False", "which nothing reads"),
    ],
)
def test_velocity_commands_of_a_controller(
    tmp_path: Path, parameters: str, own: str, stamped: str, reported_words: str
) -> None:
    files = {
        "c.yaml": "controller_manager: {ros__parameters: "
        "{drive: {type: diff_drive_controller/DiffDriveController}}}\n"
        f"drive: {{ros__parameters: {{{parameters}}}}}\n"
    }
    text = (
        NODE.format("controller_manager", "ros2_control_node", f"parameters=['{tmp_path}/c.yaml']")
        + SPAWNER.format(["drive"])
        + TELEOP.format(
            f"remappings=[('cmd_vel', '{own}')], "
            f"parameters=[{{'publish_stamped_twist': {stamped}}}]"
        )
    )
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert [reported_words in one.message for one in found] == [True] * bool(reported_words)


@pytest.mark.parametrize(
    ("parameters", "count"),
    [
        ("parameters=['{}/mux.yaml']", 1),
        ("", 0),  # the default depends on the distribution
        ("arguments=['--ros-args', '-p', 'use_stamped:=true']", 0),
    ],
)
def test_type_of_velocity_commands(tmp_path: Path, parameters: str, count: int) -> None:
    files = {"mux.yaml": "mux: {ros__parameters: {use_stamped: true}}\n"}
    given = f"remappings=[('cmd_vel_out', '/drive/cmd_vel')], {parameters}"
    text = MUX.format(given).replace("{}", str(tmp_path)) + COMMANDS
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    expected = naming("twist_mux", "TwistStamped", "/drive/cmd_vel", "where Twist is")
    assert [one.message for one in found] == [expected] * count


SWITCHED = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r"><link name="a"/>
<xacro:arg name="sim" default="false"/>
<ros2_control name="c" type="system"><hardware>
<xacro:if value="$(arg sim)"><plugin>{}</plugin></xacro:if>
<xacro:unless value="$(arg sim)"><plugin>{}</plugin></xacro:unless>
</hardware></ros2_control>
<gazebo><plugin filename="gz_ros2_control-system" name="p"/></gazebo></robot>"""
GZ = "gz_ros2_control/GazeboSimSystem"


@pytest.mark.parametrize(
    ("simulated", "real", "arguments", "count"),
    [
        (GZ, "acme/Driver", "", 1),
        (GZ, "acme/Driver", " sim:=true", 0),
        (GZ, "acme/OwnGazeboSystem", "", 0),
        ("acme/Other", "acme/Driver", "", 0),
        ("acme/Other", "mock_components/GenericSystem", "", 1),
    ],
)
def test_hardware_in_gazebo(
    tmp_path: Path, simulated: str, real: str, arguments: str, count: int
) -> None:
    robot = f"Command(['xacro {tmp_path}/r.xacro{arguments}'])"
    text = STATE.format(f", parameters=[{{'robot_description': {robot}}}]")
    spawn = NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    files = {"r.xacro": SWITCHED.format(simulated, real)}
    found = reported(tmp_path, "LAU022", "a.launch.py", text + spawn, files)
    assert [f"not load {real}" in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("first", "count"), [("true", 0), ("false", 1)])
def test_hardware_of_a_second_description(tmp_path: Path, first: str, count: int) -> None:
    """Elfin: the robot in Gazebo has its arguments; that for MoveIt has the defaults."""
    node = f"Command(['xacro {tmp_path}/r.xacro sim:={first}'])"
    text = STATE.format(f", parameters=[{{'robot_description': {node}}}]")
    text += NODE.format("ros_gz_sim", "create", "arguments=['-topic', 'robot_description']")
    more = f"parameters=[{{'robot_description': Command(['xacro {tmp_path}/r.xacro'])}}]"
    text += NODE.format("moveit_ros_move_group", "move_group", more)
    files = {"r.xacro": SWITCHED.format(GZ, "acme/Driver")}
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    words = "gz_ros2_control-system does not load acme/Driver"
    assert len([one for one in found if words in one.message]) == count


@pytest.mark.parametrize(
    ("is_stamped", "topic", "count"), [("true", "joy", 1), ("true", "key", 0), ("false", "joy", 0)]
)
def test_type_of_the_inputs_of_a_mux(
    tmp_path: Path, is_stamped: str, topic: str, count: int
) -> None:
    files = {
        "mux.yaml": f"twist_mux: {{ros__parameters: {{use_stamped: {is_stamped}, "
        "topics: {joystick: {topic: joy}}}}\n"
    }
    text = NODE.format(
        "twist_mux", "twist_mux", f"parameters=['{tmp_path}/mux.yaml']"
    ) + TELEOP.format(f"remappings=[('cmd_vel', '{topic}')]")
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert sum("where TwistStamped" in one.message for one in found) == count


@pytest.mark.parametrize(("own", "count"), [("", 1), (", {'use_sim_time': True}", 0)])
def test_move_group_without_simulation_time(tmp_path: Path, own: str, count: int) -> None:
    text = (
        "config = MoveItConfigsBuilder('arm', package_name='arm').to_moveit_configs()\n"
        + NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]")
        + NODE.format("moveit_ros_move_group", "move_group", f"parameters=[config.to_dict(){own}]")
    )
    found = messages(tmp_path, text)
    assert ["move_group lacks use_sim_time" in one for one in found] == [True] * count


MANAGER = NODE.format("controller_manager", "ros2_control_node", "parameters=['{}/c.yaml'], {}")


@pytest.mark.parametrize(
    ("more", "words"),
    [
        ("name='manager'", "manager is '/manager'"),
        ("name='controller_manager'", ""),
        ("name=LaunchConfiguration('x')", ""),
        ("remappings=[('~/robot_description', '/a/robot_description')]", "the robot from '/a/robo"),
        ("remappings=[('~/robot_description', '/robot_description')]", ""),
        ("remappings=[('~/robot_description', LaunchConfiguration('x'))]", ""),
    ],
)
def test_names_of_the_controller_manager(tmp_path: Path, more: str, words: str) -> None:
    text = MANAGER.format(tmp_path, more) + STATE.format("") + SPAWNER.format(["states", "arm"])
    found = reported(tmp_path, "LAU022", "a.launch.py", text, {"c.yaml": CONTROLLERS})
    assert len(found) == bool(words)
    assert all(words in one.message for one in found)


NAVIGATION = """
IncludeLaunchDescription(
    PythonLaunchDescriptionSource(
        [FindPackageShare('nav2_bringup'), '/launch/navigation_launch.py']
    ),
    launch_arguments={{'params_file': '{}/nav2.yaml'}}.items(),
)
"""
MONITOR = "collision_monitor: {{ros__parameters: {{cmd_vel_in_topic: {}, use_sim_time: true}}}}\n"


@pytest.mark.parametrize(
    ("topic", "count"), [("cmd_vel_smoothed", 0), ("cmd_vel_nav", 0), ("cmd_vel_raw", 1)]
)
def test_commands_of_the_collision_monitor(tmp_path: Path, topic: str, count: int) -> None:
    files = {"nav2.yaml": MONITOR.format(topic)}
    text = NAVIGATION.format(tmp_path)
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    words = "'velocity_smoother' publishes '/cmd_vel_smoothed'"
    assert [words in one.message for one in found] == [True] * count


@pytest.mark.parametrize(("stated", "count"), [("true", 0), ("false", 1), (None, 1)])
def test_simulation_time_in_a_file(tmp_path: Path, stated: str | None, count: int) -> None:
    values = "frequency: 30.0" + (f", use_sim_time: {stated}" if stated else "")
    text = NODE.format("rviz2", "rviz2", "parameters=[{'use_sim_time': True}]") + NODE.format(
        "robot_localization", "ekf_node", f"name='ekf', parameters=['{tmp_path}/ekf.yaml']"
    )
    files = {"ekf.yaml": f"ekf: {{ros__parameters: {{{values}}}}}\n"}
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert sum("ekf_node" in one.message for one in found) == count


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
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
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


@pytest.mark.parametrize(("topic", "count"), [("/robot_description", 0), ("/robot", 1)])
def test_the_robot_of_another_launch_file(tmp_path: Path, topic: str, count: int) -> None:
    rviz = (
        "Visualization Manager:\n  Displays:\n  - Class: rviz_default_plugins/RobotModel\n"
        f"    Description Topic: {{Value: {topic}}}\n"
    )
    text = NODE.format("rviz2", "rviz2", f"arguments=['-d', '{tmp_path}/a.rviz']")
    files = {"a.rviz": rviz, "launch/robot.launch.py": STATE.format("")}
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert ["publishes a robot" in one.message for one in found] == [True] * count


LIDAR = (
    '<robot name="r"><link name="l"/><gazebo reference="l"><sensor name="s" type="gpu_lidar">'
    "{}</sensor></gazebo></robot>"
)
BRIDGE = NODE.format("ros_gz_bridge", "parameter_bridge", "arguments=['{}']")
SCAN = BRIDGE.format("{}@sensor_msgs/msg/LaserScan[gz.msgs.LaserScan")


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
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
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
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
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
    found = reported(tmp_path, "LAU022", "a.launch.py", text)
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


OUT = "collision_monitor: {{ros__parameters: {{cmd_vel_out_topic: {}, use_sim_time: true}}}}\n"


@pytest.mark.parametrize(
    ("topic", "other", "count"),
    [
        ("drive/cmd_vel", "", 0),
        ("drive/cmd_vels", "", 1),
        ("cmd_vel_nav", "", 0),  # of the smoother
        ("mux/nav", "mux: {ros__parameters: {topics: {nav: {topic: mux/nav}}}}\n", 0),
    ],
)
def test_output_of_the_collision_monitor(
    tmp_path: Path, topic: str, other: str, count: int
) -> None:
    files = {"nav2.yaml": OUT.format(topic) + other}
    remapped = MUX.format("remappings=[('cmd_vel_out', '/drive/cmd_vel')]")
    text = NAVIGATION.format(tmp_path) + COMMANDS + remapped
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    expected = ["write drive/cmd_vel"] * count
    assert [one.help for one in found if "collision_monitor" in one.message] == expected


def test_a_mux_does_not_read_its_own_output(tmp_path: Path) -> None:
    yaml = "mux: {ros__parameters: {use_stamped: false, topics: {nav: {topic: /cmd_vel_nav}}}}\n"
    given = f"remappings=[('cmd_vel_out', '/cmd_vel_x')], parameters=['{tmp_path}/mux.yaml']"
    text = MUX.format(given) + COMMANDS
    (found,) = reported(tmp_path, "LAU022", "a.launch.py", text, {"mux.yaml": yaml})
    assert found.help == "remap /cmd_vel_x to /drive/cmd_vel"


@pytest.mark.parametrize(
    ("of_filter", "of_drive", "more", "count"),
    [
        ("false", "false", "", 1),
        ("true", "false", "", 0),
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
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert [one.help for one in found if "odometry" in one.message] == [
        "write publish_tf: true"
    ] * count


@pytest.mark.parametrize(
    ("real", "given", "count"),
    [
        ("acme/Driver", "", 1),
        ("mock_components/GenericSystem", "", 1),
        ("acme/MujocoSystem", "", 0),
        ("acme/Driver", ", {'use_sim_time': False}", 0),
    ],
)
def test_simulation_time_of_a_robot(tmp_path: Path, real: str, given: str, count: int) -> None:
    robot = f"Command(['xacro {tmp_path}/r.xacro'])"
    text = STATE.format(f", parameters=[{{'robot_description': {robot}}}]")
    text += MANAGER.format(tmp_path, "").replace("c.yaml'", f"c.yaml'{given}")
    stated = "controller_manager: {ros__parameters: {use_sim_time: true}}\n"
    files = {"r.xacro": SWITCHED.format(GZ, real), "c.yaml": stated}
    found = reported(tmp_path, "LAU022", "a.launch.py", text, files)
    assert sum("controllers wait with use_sim_time" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("parameters", "yaml", "more", "count"),
    [
        ("{'robot_description': x}, ", "use_stamped: true", "", 1),
        ("{'robot_description': x}, ", "use: true", "", 0),
        ("", "use_stamped: true", "", 0),
        ("{'robot_description': x}, ", "use_stamped: true", "generate_rsp_launch(x)\n", 0),
        ("{'robot_description': x}, ", "use_stamped: true", STATE.format(""), 0),
        ("{'robot_description': x}, ", "use_stamped: true", NODE.format("mine", "a", ""), 0),
    ],
)
def test_a_manager_without_a_robot(
    tmp_path: Path, parameters: str, yaml: str, more: str, count: int
) -> None:
    """UTNuclearRoboticsPublic/netft_utils#18: since Jazzy the robot is no parameter."""
    text = MANAGER.format(tmp_path, "").replace("parameters=[", f"parameters=[{parameters}")
    files = {"c.yaml": f"controller_manager: {{ros__parameters: {{{yaml}}}}}\n"}
    found = reported(tmp_path, "LAU022", "a.launch.py", text + more, files)
    assert sum("waits for /robot_description" in one.message for one in found) == count
