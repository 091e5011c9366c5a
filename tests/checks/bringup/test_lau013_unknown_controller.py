"""LAU013: see the rule."""

from pathlib import Path

import pytest

from tests.controls import GZ, ROBOT, control, driven
from tests.launched import reported
from tests.naming import naming
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity

ROS_1 = {"config/c.yaml": "ns:\n  arm_controller:\n    type: effort_controllers/X\n"}
ROS_2 = {
    "config/c.yaml": """\
/**:
  controller_manager:
    ros__parameters:
      arm_controller:
        type: joint_trajectory_controller/JointTrajectoryController
/**:
  arm_controller:
    ros__parameters:
      joints: [elbow]
"""
}
LOAD_1 = '<rosparam file="$(find arm)/config/c.yaml"/>\n'
SPAWN_1 = '<node pkg="controller_manager" type="{}" name="n" args="{}"/>'
LOAD_2 = "Node(package='controller_manager', executable='ros2_control_node', parameters=[CONFIG])\n"
SPAWN_2 = "Node(package='controller_manager', executable='spawner', arguments=[{}])"
HEAD_2 = "CONFIG = FindPackageShare('arm').find('arm') + '/config/c.yaml'\n"


@pytest.mark.parametrize(
    ("executable", "args"),
    [("spawner", "arm_controler"), ("spawner", "--timeout 5 /ns/grip"), ("spawner.py", "a")],
)
def test_ros_1(tmp_path: Path, executable: str, args: str) -> None:
    text = LOAD_1 + SPAWN_1.format(executable, args)
    (found,) = reported(tmp_path, "LAU013", "a.launch", text, ROS_1)
    name = args.rpartition(" ")[2].rpartition("/")[2]
    assert found.message.startswith(f"controller '{name}' is not defined")
    assert found.span.line == 3


def test_controllers_with_a_space_in_their_names(tmp_path: Path) -> None:
    """An export of Fusion 360 with its names of joints: the spawner reads two controllers."""
    files = {"config/c.yaml": ROS_1["config/c.yaml"].replace("arm_c", "Revolute 1_c")}
    text = LOAD_1 + SPAWN_1.format("spawner", "Revolute 1_controller")
    found = reported(tmp_path, "LAU013", "a.launch", text, files)
    assert [one.help for one in found] == [naming("Revolute 1_controller")] * 2


def test_several_controllers_of_one_spawner(tmp_path: Path) -> None:
    text = LOAD_1 + SPAWN_1.format("controller_manager", "spawn arm_controller a b")
    assert len(reported(tmp_path, "LAU013", "a.launch", text, ROS_1)) == 2


@pytest.mark.parametrize(
    ("executable", "args"),
    [
        ("spawner", "arm_controller --namespace ns"),
        ("spawner", "ns/arm_controller"),
        ("spawner", "$(find arm)/config/c.yaml"),  # all controllers of the file
        ("spawner", "$(env CONTROLLERS)"),
        ("controller_manager", "unspawn x"),
        ("unspawner", "x"),
    ],
)
def test_defined_or_unknown_controller_is_accepted(
    tmp_path: Path, executable: str, args: str
) -> None:
    text = LOAD_1 + SPAWN_1.format(executable, args)
    assert reported(tmp_path, "LAU013", "a.launch", text, ROS_1) == []


@pytest.mark.parametrize(
    "parameters",
    [
        '<rosparam command="load" file="$(find arm)/config/c.yaml" ns="grip"/>',
        "<rosparam>\ngrip:\n  type: effort_controllers/X\n</rosparam>",
        '<param name="grip/type" value="effort_controllers/X"/>',
        '<node name="n" pkg="p" type="t"><param name="/grip/type" value="a/B"/></node>',
    ],
)
def test_parameters_of_the_launch_file_are_accepted(tmp_path: Path, parameters: str) -> None:
    text = LOAD_1 + parameters + SPAWN_1.format("spawner", "grip")
    assert reported(tmp_path, "LAU013", "a.launch", text, ROS_1) == []


@pytest.mark.parametrize(
    "spawn",
    [
        SPAWN_2.format("'arm_controler'"),
        SPAWN_2.format("'arm_controler', '--controller-manager', '/cm'"),
        SPAWN_2.format("'-c', '/cm', 'grip'"),
        "ExecuteProcess(cmd=['ros2', 'control', 'load_controller', '--set-state', 'active', 'x'])",
        SPAWN_2.format("'x'") + "; Node(package='twist_stamper')",  # it defines no controller
    ],
)
def test_ros_2(tmp_path: Path, spawn: str) -> None:
    (found,) = reported(tmp_path, "LAU013", "a.launch.py", HEAD_2 + LOAD_2 + spawn, ROS_2)
    assert found.span.line == 3


@pytest.mark.parametrize(
    "spawn",
    [
        SPAWN_2.format("'arm_controller', '-c', '/cm'"),
        SPAWN_2.format("'x', '--controller-type', 'a/B'"),
        SPAWN_2.format("name"),
        SPAWN_2.format("'arm_controller', '--ros-args', 'x'"),
        "Node(parameters=[FindPackageShare('grip').find('grip') + '/c.yaml'])\n"
        + SPAWN_2.format("'x'"),
    ],
)
def test_valid_in_ros_2(tmp_path: Path, spawn: str) -> None:
    assert reported(tmp_path, "LAU013", "a.launch.py", HEAD_2 + LOAD_2 + spawn, ROS_2) == []


@pytest.mark.parametrize(("name", "count"), [("arm_controler", 1), ("grip", 0)])
def test_without_own_file_only_typos(tmp_path: Path, name: str, count: int) -> None:
    text = SPAWN_2.format(repr(name))
    assert len(reported(tmp_path, "LAU013", "a.launch.py", text, ROS_2)) == count


@pytest.mark.parametrize(
    ("manager", "more", "count"),
    [("", "", 1), ("", ", '--param-file', CONFIG", 0), ("arm: {type: a/B}", "", 0)],
)
def test_a_type_that_the_manager_does_not_read(
    tmp_path: Path, manager: str, more: str, count: int
) -> None:
    yaml = f"controller_manager: {{ros__parameters: {{update_rate: 100, {manager}}}}}\n"
    yaml += "arm: {ros__parameters: {type: a/B}}\n"
    text = HEAD_2 + LOAD_2 + SPAWN_2.format(f"'arm'{more}")
    found = reported(tmp_path, "LAU013", "a.launch.py", text, {"config/c.yaml": yaml})
    assert ["type for 'arm'" in one.message for one in found] == [True] * count


def test_several_controllers_in_one_item(tmp_path: Path) -> None:
    text = HEAD_2 + LOAD_2 + SPAWN_2.format("'arm_controller other'")
    (found,) = reported(tmp_path, "LAU013", "a.launch.py", text, ROS_2)
    assert found.help == naming("arm_controller", "other")


def test_controllers_that_nothing_starts(tmp_path: Path) -> None:
    yaml = "controller_manager: {ros__parameters: {states: {type: a/B}, arm: {type: a/B}}}\n"
    text = HEAD_2 + LOAD_2 + SPAWN_2.format("'arm', 'broadcaster'")
    (found,) = reported(tmp_path, "LAU013", "a.launch.py", text, {"config/c.yaml": yaml})
    assert found.help == naming("states", "broadcaster")


CHAINED = """controller_manager:
  ros__parameters:
    drive: {type: diff_drive_controller/DiffDriveController}
    pid: {type: pid_controller/PidController}
drive:
  ros__parameters: {left_wheel_names: [%s/left], right_wheel_names: [right]}
"""


@pytest.mark.parametrize(
    ("prefix", "words", "message"),
    [
        ("pid", "'pid', 'drive'", ""),
        ("pid", "'drive', 'pid'", "but 'pid' is activated later"),
        ("pid", "'drive', 'pid', '--activate-as-group'", ""),
        ("pid", "'drive', 'pid', option", ""),
        ("pid", "'drive'", "'pid' is not started"),
        ("pdi", "'pid', 'drive'", "there is no controller 'pdi'; did you mean 'pid'?"),
    ],
)
def test_controllers_in_a_chain(tmp_path: Path, prefix: str, words: str, message: str) -> None:
    text = HEAD_2 + LOAD_2 + SPAWN_2.format(words)
    files = {"config/c.yaml": CHAINED % prefix}
    found = reported(tmp_path / "arm", "LAU013", "a.launch.py", text, files)
    assert [one.message.endswith(message) for one in found] == [True] * bool(message)


def test_a_joint_with_a_slash_in_its_name(tmp_path: Path) -> None:
    """A robot of Plankton: fish_hpurv/fin1_joint is a joint, and no interface of a controller."""
    robot = ROBOT.replace('"swing"', '"pid/left"') + control(driven("pid/left"))
    files = {"r.urdf": whole_robot(robot), "config/c.yaml": CHAINED % "pid"}
    text = DESCRIBED + HEAD_2 + LOAD_2 + SPAWN_2.format("'drive'")
    assert reported(tmp_path / "arm", "LAU013", "a.launch.py", text, files) == []


BROADCASTER = """controller_manager:
  ros__parameters:
    imu: {type: imu_sensor_broadcaster/IMUSensorBroadcaster}
imu:
  ros__parameters: {sensor_name: base_imu, frame_id: base}
"""
DESCRIBED = """from launch_ros.actions import Node

nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher",
         parameters=[{"robot_description": open("../r.urdf").read()}]),
]
"""


@pytest.mark.parametrize(
    ("plugin", "parts", "count"),
    [
        (GZ, "", 1),
        (GZ, '<sensor name="base_imu"><state_interface name="orientation.x"/></sensor>', 0),
        (GZ, '<sensor name="other"/>', 0),  # RCT032 compares the names
        ("mine/Hardware", "", 0),  # which may offer more than it lists
    ],
)
def test_a_broadcaster_without_a_sensor(
    tmp_path: Path, plugin: str, parts: str, count: int
) -> None:
    files = {
        "r.urdf": whole_robot(ROBOT + control(driven("swing"), parts, plugin=plugin)),
        "config/c.yaml": BROADCASTER,
    }
    text = DESCRIBED + HEAD_2 + LOAD_2 + SPAWN_2.format("'imu'")
    found = reported(tmp_path / "arm", "LAU013", "a.launch.py", text, files)
    assert ["reads sensor 'base_imu'" in one.message for one in found] == [True] * count


INCLUDE = (
    "IncludeLaunchDescription(PythonLaunchDescriptionSource("
    "FindPackageShare('arm').find('arm') + '/launch/spawn.launch.py'))\n"
)


@pytest.mark.parametrize(
    ("name", "including", "count"),
    [
        ("'grip'", HEAD_2 + LOAD_2 + INCLUDE, 1),
        ("'arm_controller'", HEAD_2 + LOAD_2 + INCLUDE, 0),
        ("'grip'", HEAD_2 + LOAD_2, 0),  # it may be included elsewhere
        ("'grip'", INCLUDE, 0),  # nothing loads controllers
        ("'grip'", HEAD_2 + LOAD_2 + INCLUDE + INCLUDE.replace("'arm'", "'acme'"), 0),
    ],
)
def test_an_included_file_with_spawners(
    tmp_path: Path, name: str, including: str, count: int
) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus: the file that includes it starts the robot."""
    files = {**ROS_2, "launch/robot.launch.py": including}
    found = reported(tmp_path, "LAU013", "spawn.launch.py", SPAWN_2.format(name), files)
    assert [one.span.text for one in found] == [name] * count


@pytest.mark.parametrize(("name", "count"), [("grip", 0), ("hand", 1)])
def test_a_file_with_controllers_that_is_passed_by_the_launch_file_of_a_robot(
    tmp_path: Path, name: str, count: int
) -> None:
    """CHAMP: the launch file of each robot passes its own file to that of Gazebo."""
    text = '<arg name="file" default="$(find arm)/config/c.yaml"/><rosparam file="$(arg file)"/>\n'
    include = '<include file="$(find arm)/launch/spawn.launch">'
    include += '<arg name="file" value="$(find robot)/c.yaml"/></include>'
    files = {
        **ROS_1,
        "../robot/package.xml": "<package><name>robot</name></package>",
        "../robot/c.yaml": f"{name}: {{type: a/B}}",
        "../robot/robot.launch": f"<launch>{include}</launch>",
    }
    text += SPAWN_1.format("spawner", "arm_controller grip")
    found = reported(tmp_path / "src/arm", "LAU013", "spawn.launch", text, files)
    assert len(found) == count


@pytest.mark.parametrize(
    ("including", "more", "count"),
    [
        (HEAD_2 + LOAD_2 + INCLUDE, "", 1),
        (HEAD_2 + LOAD_2 + INCLUDE, ", '--param-file', unknown", 0),
        (HEAD_2 + LOAD_2, "", 0),
    ],
)
def test_a_type_where_only_the_spawner_of_an_included_file_reads_it(
    tmp_path: Path, including: str, more: str, count: int
) -> None:
    files = {
        "config/c.yaml": "grip: {ros__parameters: {type: a/B}}",
        "launch/robot.launch.py": including,
    }
    found = reported(tmp_path, "LAU013", "spawn.launch.py", SPAWN_2.format("'grip'" + more), files)
    assert ["has no type for 'grip'" in one.message for one in found] == [True] * count


TYPES, OWN = (f"/**:\n{part}" for part in ROS_2["config/c.yaml"].split("/**:\n")[1:])
APART = {"config/c.yaml": TYPES, "config/own.yaml": OWN}
FILE_2 = "FindPackageShare('arm').find('arm') + '/config/own.yaml'"


@pytest.mark.parametrize(
    ("more", "files", "count"),
    [
        ("", APART, 1),
        (f", '--param-file', {FILE_2}", APART, 0),
        (", name", APART, 0),  # perhaps the option
        ("", {**APART, "config/own.yaml": OWN.replace("arm_c", "leg_c")}, 0),
        ("", {**APART, "config/own.yaml": OWN.replace("joints", "gains")}, 0),
        ("", {**APART, "launch/b.launch.py": f"Node(parameters=[{FILE_2}])"}, 0),
        ("", {"config/c.yaml": TYPES + OWN.removeprefix("/**:\n")}, 0),
    ],
)
def test_parameters_in_a_file_that_nothing_loads(
    tmp_path: Path, more: str, files: dict[str, str], count: int
) -> None:
    text = HEAD_2 + LOAD_2 + SPAWN_2.format(f"'arm_controller'{more}")
    found = reported(tmp_path, "LAU013", "a.launch.py", text, files)
    assert [one.message for one in found] == [naming("arm_controller")] * count
    assert all(one.help == naming("--param-file", "own.yaml") for one in found)
    assert all(one.span.text == "'arm_controller'" for one in found)


@pytest.mark.parametrize("value", ["true", "false"])
def test_controllers_of_a_group_that_is_off(tmp_path: Path, value: str) -> None:
    """Niryo: the group for Gazebo loads the controllers of another package, and starts them."""
    files = {
        "config/c.yaml": ROS_1["config/c.yaml"],
        "../sim/package.xml": "<package><name>sim</name></package>",
        "../sim/c.yaml": "grip_controller:\n  type: effort_controllers/X\n",
    }
    load = '<rosparam file="$(find sim)/c.yaml"/>'
    group = f'<group if="$(arg sim)">{load}{SPAWN_1.format("spawner", "grip_controller")}</group>'
    text = f'<arg name="sim" default="{value}"/>{LOAD_1}{group}'
    assert reported(tmp_path / "src" / "arm", "LAU013", "a.launch", text, files) == []


@pytest.mark.parametrize(
    ("passed", "severity"),
    [
        ('<arg name="controllers" value="arm_controller"/>', Severity.WARNING),
        ("", Severity.ERROR),
    ],
)
def test_a_default_that_including_files_replace(
    tmp_path: Path, passed: str, severity: Severity
) -> None:
    """iiwa_stack: the default names controllers of another version."""
    text = '<arg name="controllers" default="grip"/>' + LOAD_1
    text += SPAWN_1.format("spawner", "$(arg controllers)")
    include = f'<include file="$(find arm)/launch/a.launch">{passed}</include>'
    files = {**ROS_1, "launch/robot.launch": f"<launch>{include}</launch>"}
    (found,) = reported(tmp_path, "LAU013", "a.launch", text, files)
    assert found.severity is severity
    assert ("default of 'controllers'" in found.help) is (severity is Severity.WARNING)
