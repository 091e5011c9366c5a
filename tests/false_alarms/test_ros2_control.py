"""What the hardware has and the simulator has not, in a description for both."""

from pathlib import Path

import pytest

from tests import driving
from tests.controls import (
    GZ,
    MOCK,
    ROBOT,
    control,
    controller,
    driven,
    plugin,
    reported_with_file,
    transmission,
)
from tests.gazebos import WHEELS, sensor
from tests.launched import launch
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.robot.samples import joint_xml, xacro_xml
from urdfkit.text.diagnostic import Severity

SENSOR = '<sensor name="finger"><state_interface name="Present Pressure 1"/></sensor>'


@pytest.mark.parametrize(
    ("part", "severity"),
    [
        (driven("swing", state="torque_enable"), Severity.INFO),
        (SENSOR, Severity.INFO),
        (driven("swing", state="positon"), Severity.WARNING),
        (driven("swing", command="torque_enable"), Severity.WARNING),
    ],
)
def test_state_interfaces_of_the_hardware_alone(part: str, severity: Severity) -> None:
    """ROBOTIS's hand and arms."""
    (found,) = reported("RCT017", ROBOT + control(part, plugin=GZ))
    assert found.severity is severity


@pytest.mark.parametrize(("tag", "count"), [("ec_module", 0), ("ecmodules", 1)])
def test_modules_of_the_ethercat_driver(tag: str, count: int) -> None:
    """SIMCO's base: every joint has the module of its drive."""
    module = f'<{tag} name="drive"><plugin>ethercat_generic_plugins/EcCiA402Drive</plugin></{tag}>'
    robot = ROBOT + control(driven("swing", more=module))
    assert len(reported("RCT017", robot)) == count


def test_a_role_may_be_empty() -> None:
    """The arm of a youBot: the loader of a SimpleTransmission does not use the role."""
    inside = (
        '<plugin>transmission_interface/SimpleTransmission</plugin><actuator name="m" role=""/>'
    )
    block = f'<transmission name="t">{inside}<joint name="swing" role=""/></transmission>'
    assert reported("RCT017", ROBOT + control(driven("swing"), block)) == []


@pytest.mark.parametrize(
    ("hardware", "tag", "severity"),
    [
        ("acme/Bus", "ec_interface", Severity.INFO),
        ("acme/Bus", "parm", Severity.WARNING),
        (MOCK, "ec_interface", Severity.WARNING),
    ],
)
def test_elements_for_the_hardware_alone(hardware: str, tag: str, severity: Severity) -> None:
    """The same arm: the hardware finds its bus in the text of the URDF."""
    block = control(driven("swing"), plugin=hardware)
    block = block.replace("</hardware>", f"<{tag}>eth0</{tag}></hardware>")
    (found,) = reported("RCT017", ROBOT + block)
    assert found.severity is severity


@pytest.mark.parametrize(
    ("library", "count"), [("gazebo_ros_control", 1), ("gazebo_ros2_control", 0)]
)
def test_the_class_of_the_simulation_is_a_tag_of_ros_1(library: str, count: int) -> None:
    """OnRobot's grippers: gazebo_ros2_control takes the class from <ros2_control>."""
    kind = "<robotSimType>gazebo_ros2_control/DefaultRobotHWSim</robotSimType>"
    robot = ROBOT + transmission("swing") + plugin(f"lib{library}.so", kind)
    found = [one for one in reported("RCT010", robot) if "DefaultRobotHWSim" in one.message]
    assert len(found) == count


@pytest.mark.parametrize(
    ("library", "count"), [("gz_ros2_control-system", 0), ("gz-sim-imu-system", 1)]
)
def test_a_model_in_sdf_loads_the_controllers(tmp_path: Path, library: str, count: int) -> None:
    """An A1 whose SDF Gazebo starts; the URDF is for the controller manager."""
    package = add_package(tmp_path, "p")
    robot = add_file(
        package / "urdf" / "robot.urdf", whole_robot(ROBOT + control(driven("swing"), plugin=GZ))
    )
    model = f'<sdf version="1.9"><model name="a"><plugin filename="lib{library}.so"/></model></sdf>'
    add_file(package / "model.sdf", model)
    assert len(check(robot, select=["RCT010"]).diagnostics) == count


CANOPEN = "canopen_ros2_control/RobotSystem"
LEFT = '<joint name="left_joint"/>'
MEASURED = '<joint name="left_joint"><state_interface name="position"/></joint>'
POSITION = """\
controller_manager:
  ros__parameters:
    move:
      type: forward_command_controller/ForwardCommandController
move:
  ros__parameters:
    joints: [left_joint]
    interface_name: position
"""


@pytest.mark.parametrize(
    ("joint", "hardware", "severities"),
    [
        (LEFT, CANOPEN, []),
        (LEFT, MOCK, [Severity.ERROR]),
        (MEASURED, CANOPEN, [Severity.INFO]),
        (MEASURED, GZ, [Severity.ERROR]),
        (driven("left_joint", command="velocity"), CANOPEN, [Severity.WARNING]),
    ],
)
def test_a_hardware_that_exports_interfaces_by_itself(
    tmp_path: Path, joint: str, hardware: str, severities: list[Severity]
) -> None:
    """ROS 2 CANopen: the joint of a drive has an ID and no interface, or those of its state."""
    robot = WHEELS + control(joint, plugin=hardware)
    found = driving.reported(tmp_path, "RCT021", POSITION, robot)
    assert [one.severity for one in found] == severities


@pytest.mark.parametrize(("file", "count"), [("CMakeLists.txt", 0), ("cmake/driveConfig.cmake", 1)])
def test_a_controller_of_the_workspace(tmp_path: Path, file: str, count: int) -> None:
    """Yahboom's rosmaster: a mecanum_drive_controller of its own, with other parameters."""
    add_package(tmp_path / "controller", "diff_drive_controller")
    add_file(tmp_path / "controller" / file)
    add_package(tmp_path, "robot")
    text = driving.DRIVE.replace("wheel_radius", "wheels_radius").replace("0.3", "3")
    found = driving.reported(tmp_path, "RCT034", text)
    assert bool(found) == bool(count)


@pytest.mark.parametrize(
    ("more", "severity"),
    [("", Severity.WARNING), ("    use_stamped: true\n", Severity.ERROR)],
)
def test_limits_whose_sign_only_later_versions_check(
    tmp_path: Path, more: str, severity: Severity
) -> None:
    """A receptionist of Humble with a positive ``min_velocity`` and its limits switched off."""
    add_package(tmp_path, "robot")
    (tmp_path / "mux.yaml").write_text(f"twist_mux:\n  ros__parameters:\n    a: 1\n{more}")
    (tmp_path / "launch").mkdir()
    mux = '<param from="$(find-pkg-share robot)/mux.yaml"/>'
    (tmp_path / "launch" / "mux.launch.xml").write_text(
        launch(f'<node pkg="twist_mux" exec="twist_mux">{mux}</node>')
    )
    text = f"{driving.DRIVE}    linear.x.min_velocity: 4.0\n"
    (found,) = driving.reported(tmp_path, "RCT034", text)
    assert (found.severity, found.message) == (
        severity,
        naming("drive", "linear.x.min_velocity", "4.0", "<= 0"),
    )
    assert ("Jazzy" in found.message) == (severity is Severity.WARNING)


def test_transmissions_that_a_plugin_of_the_robot_may_load() -> None:
    """legged_control: `gazebo_ros_control` with a library of its own."""
    moved = ROBOT + transmission("swing")
    for file, count in (("libgazebo_ros_imu_sensor.so", 1), ("liblegged_hw_sim.so", 0)):
        found = reported("RCT010", moved + plugin(file), targets=("classic-ros1",))
        assert len(found) == count


@pytest.mark.parametrize(("first", "count"), [("PositionJoint", 0), ("ForceTorqueSensor", 1)])
def test_interfaces_behind_the_first_one(first: str, count: int) -> None:
    """pal_robotiq_gripper: Gazebo reads the first interface of a joint."""
    state = "</hardwareInterface><hardwareInterface>hardware_interface/JointStateInterface"
    driven = transmission("swing", f"hardware_interface/{first}Interface{state}")
    robot = ROBOT + driven + plugin("libgazebo_ros_control.so")
    assert len(reported("RCT017", robot, targets=("classic-ros1",))) == count


def test_a_sensor_whose_broadcaster_has_the_frame() -> None:
    """Elkapod: the IMU is read by ros2_control."""
    imu = sensor("imu", "", "base").replace('name="s"', 'name="imu"')
    part = '<sensor name="{}"><state_interface name="orientation.x"/></sensor>'
    for name, count in (("imu", 0), ("other", 1)):
        robot = ROBOT + control(part.format(name), plugin=GZ) + imu
        assert len(reported("GAZ058", robot, targets=("gz-harmonic",))) == count


@pytest.mark.parametrize(("name", "count"), [("left_force", 0), ("left_camera", 1)])
def test_sensors_that_are_interfaces_of_one(name: str, count: int) -> None:
    """Quadrupeds: the force sensors of the feet are one sensor of ros2_control."""
    force = '<sensor name="force"><state_interface name="left_force"/></sensor>'
    feet = sensor("force_torque", "", "base").replace('name="s"', f'name="{name}"')
    robot = ROBOT + control(force, plugin=GZ) + feet
    assert len(reported("GAZ058", robot, targets=("gz-harmonic",))) == count


@pytest.mark.parametrize(
    ("left", "right", "severity"),
    [("wheel_0", "wheel_1", "warning"), ("swing", "wheel_1", "error"), ("swnig", "", "error")],
)
def test_a_robot_of_ros_1_with_hardware_of_its_own(
    tmp_path: Path, left: str, right: str, severity: str
) -> None:
    """A base whose node names its wheels itself, and whose model has the plugin of Gazebo, too."""
    text = f"b:\n  type: diff_drive_controller/DiffDriveController\n  left_wheel: {left}\n"
    add_file(tmp_path / "c.yaml", f"{text}  right_wheel: {right}\n".encode())
    robot = whole_robot(ROBOT + plugin("libgazebo_ros_control.so"))
    add_file(tmp_path / "r.urdf", robot.encode())
    add_file(
        tmp_path / "r.launch",
        b'<launch><rosparam command="load" file="$(dirname)/c.yaml"/>'
        b'<param name="robot_description" textfile="$(dirname)/r.urdf"/></launch>',
    )
    found = check(tmp_path / "r.launch", select=["RCT001"]).diagnostics
    assert {one.severity.value for one in found} == {severity}


@pytest.mark.parametrize(("state", "count"), [("velocity", 0), ("effort", 1)])
@pytest.mark.parametrize("is_first", [True, False])
def test_a_joint_of_two_hardware_components(
    tmp_path: Path, state: str, count: int, is_first: bool
) -> None:
    """A block for Gazebo and one for mock hardware: the joint offers what either lists."""
    more = f'<state_interface name="{state}"/>'
    blocks = [control(driven("swing", more=more), plugin=GZ), control(driven("swing"), plugin=MOCK)]
    needs = "[position, velocity]"
    text = controller("c", joints="[swing]", state_interfaces=needs)
    joined = "".join(blocks if is_first else blocks[::-1])
    assert len(reported_with_file("RCT021", tmp_path, text, joined)) == count


@pytest.mark.parametrize(("radius", "count"), [("0.1", 0), ("0.2", 1)])
def test_controllers_of_two_robots_in_one_file(tmp_path: Path, radius: str, count: int) -> None:
    """ackermann_multiagent_ros2: a model car and a Prius, whose joints have the same names."""
    sides = {"left_wheel_names": "[left_joint]", "right_wheel_names": "[right_joint]"}
    kind = "diff_drive_controller/DiffDriveController"
    car = controller("car", kind, **sides, wheel_separation="0.3", wheel_radius=radius)
    prius = controller("prius", kind, **sides, wheel_separation="1.5", wheel_radius="0.4")
    assert len(driving.reported(tmp_path, "RCT014", prius + car)) == count
    assert len(driving.reported(tmp_path, "RCT014", prius)) == 2


@pytest.mark.parametrize(("exported", "count"), [("linear_acceleration_x", 0), ("position", 1)])
def test_interfaces_that_hardware_of_the_workspace_exports(
    tmp_path: Path, exported: str, count: int
) -> None:
    """Bolt's IMU: the fix would have given the interface a name that its hardware does not have."""
    package = add_package(tmp_path, "bolt_description")
    imu = '<sensor name="imu"><state_interface name="linear_acceleration_x"/></sensor>'
    text = whole_robot(ROBOT + control(driven("swing"), imu, plugin="bolt/System"))
    robot = add_file(package / "urdf" / "bolt.urdf", text.encode())
    hardware = add_package(tmp_path, "bolt_hardware")
    add_file(hardware / "src" / "system.cpp", f'export_state("imu", "{exported}");'.encode())
    assert len(check(robot, select=["RCT017"]).diagnostics) == count


@pytest.mark.parametrize(("joint", "count"), [("slide", 0), ("turn", 1)])
def test_a_controller_of_a_joint_that_an_argument_disables(
    tmp_path: Path, joint: str, count: int
) -> None:
    """odrive_ros2_control: two axes, of which the launch file enables one."""
    (tmp_path / "c.yaml").write_text(
        "controller_manager:\n  ros__parameters:\n    both:\n      type: "
        "joint_trajectory_controller/JointTrajectoryController\n"
        f"both:\n  ros__parameters:\n    joints: [swing, {joint}]\n"
    )
    second = joint_xml("prismatic", name="slide", child="tool")
    xacro = xacro_xml(
        '<xacro:arg name="has_slide" default="false"/>',
        '<link name="base"/><link name="arm"/>' + joint_xml("continuous", name="swing"),
        f'<xacro:if value="$(arg has_slide)"><link name="tool"/>{second}</xacro:if>',
        control(driven("swing"), plugin=GZ)
        + plugin("gz_ros2_control-system", f"<parameters>{tmp_path}/c.yaml</parameters>"),
    )
    robot = add_file(tmp_path / "r.urdf.xacro", xacro.encode())
    assert len(check(robot, select=["RCT001"]).diagnostics) == count


_CHOICE = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction
from launch.conditions import UnlessCondition
from launch.substitutions import Command, LaunchConfiguration
from launch_ros.actions import Node
SIM = LaunchConfiguration("sim")

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument("sim", default_value="false"),
        Node(package="robot_state_publisher", executable="robot_state_publisher", parameters=[
            {{"robot_description": Command(["xacro ", "{here}/r.xacro", " sim:=", SIM])}}]),
        {node},
    ])
"""
_MANAGER = 'Node(package="controller_manager", executable="ros2_control_node", parameters=[FILE]{})'
_SIMULATION = """from launch import LaunchDescription
from launch.actions import IncludeLaunchDescription
def generate_launch_description():
    return LaunchDescription([IncludeLaunchDescription("{here}/launch/a.launch.py",
        launch_arguments={{"sim": "true"}}.items())])
"""


@pytest.mark.parametrize(
    ("node", "count"),
    [
        (f"GroupAction([{_MANAGER.format('')}], condition=UnlessCondition(SIM))", 0),
        (_MANAGER.format(", condition=UnlessCondition(SIM)"), 0),
        (_MANAGER.format(""), 1),
    ],
)
def test_parameters_of_a_node_that_the_launch_file_switches_off(
    tmp_path: Path, node: str, count: int
) -> None:
    """Monash Nova Rover: the efforts of the arm are read of the real hardware only."""
    effort = '<xacro:unless value="$(arg sim)"><state_interface name="effort"/></xacro:unless>'
    robot = (
        '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
        '<xacro:arg name="sim" default="false"/><link name="base"/><link name="arm"/>'
        '<joint name="j" type="revolute"><parent link="base"/><child link="arm"/>'
        '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>'
        '<ros2_control name="c" type="system"><hardware><plugin>a/B</plugin></hardware>'
        f'<joint name="j"><command_interface name="position"/><state_interface name="position"/>'
        f"{effort}</joint></ros2_control></robot>"
    )
    manager = "controller_manager:\n  ros__parameters:\n    b: {type: %s}\n"
    kind = "joint_state_broadcaster/JointStateBroadcaster"
    broadcaster = "b:\n  ros__parameters:\n    joints: [j]\n    interfaces: [effort]\n"
    add_package(tmp_path, "arm")
    path = add_file(tmp_path / "r.xacro", robot.encode())
    add_file(tmp_path / "c.yaml", (manager % kind + broadcaster).encode())
    here = str(tmp_path)
    text = _CHOICE.format(here=here, node=node).replace("FILE", f'"{here}/c.yaml"')
    add_file(tmp_path / "launch" / "a.launch.py", text.encode())
    simulation = _SIMULATION.format(here=here)
    add_file(tmp_path / "launch" / "simulation.launch.py", simulation.encode())
    assert len(check(path, select=["RCT021"]).diagnostics) == count


@pytest.mark.parametrize(
    ("joints", "messages"),
    [
        (
            "[waist, neck, elbow, wrist]",
            [naming("none", "4")],
        ),
        (
            "[waist, neck, elbow, slide]",
            [f"unknown joint '{n}'" for n in ("waist", "neck", "elbow")],
        ),
        ("[waist, neck]", ["unknown joint 'waist'", "unknown joint 'neck'"]),
    ],
)
def test_controllers_of_another_robot(tmp_path: Path, joints: str, messages: list[str]) -> None:
    """Vizzy's base alone is started with the controllers of its arms: nothing is misspelt."""
    found = reported_with_file("RCT001", tmp_path, controller("arm", joints=joints), "")
    assert [one.message.removeprefix("controller 'arm': ") for one in found] == messages
    if len(messages) == 1:
        assert found[0].span.text == "waist"
        assert "compared with this robot" in [note.message for note in found[0].related]


@pytest.mark.parametrize(
    ("use", "count"), [("<rosparam file='{}'/>", 0), ("<param from='{}'/>", 1)]
)
def test_parameters_of_a_node_of_ros_1(tmp_path: Path, use: str, count: int) -> None:
    """moveit_benchmark_suite: a section of its YAML files is called ``parameters``."""
    add_file(tmp_path / "c.yaml", b"benchmark:\n  parameters:\n    runs: 9\n")
    add_file(tmp_path / "r.urdf", whole_robot(ROBOT).encode())
    node = f"<node pkg='robot_state_publisher' exec='a'>{use.format('$(dirname)/c.yaml')}</node>"
    robot = '<param name="robot_description" textfile="$(dirname)/r.urdf"/>'
    add_file(tmp_path / "r.launch", f"<launch>{robot}{node}</launch>".encode())
    found = check(tmp_path / "r.launch", select=["RCT026"]).diagnostics
    assert [one.span.line for one in found] == [2] * count


@pytest.mark.parametrize(("above", "count"), [("", 1), ("servo:\n", 1), ("servo:\n joints:\n", 0)])
def test_a_template_of_controllers(tmp_path: Path, above: str, count: int) -> None:
    """jsk_aerial_robot: a program adds the joint to the parameters that all its servos share."""
    kind = "type: effort_controllers/JointPositionController"
    add_file(
        tmp_path / "c.yaml", f"{above}   simulation:\n    {kind}\n    pid: {{p: 9}}\n".encode()
    )
    add_file(tmp_path / "r.urdf", whole_robot(ROBOT).encode())
    robot = '<param name="robot_description" textfile="$(dirname)/r.urdf"/>'
    load = '<rosparam command="load" file="$(dirname)/c.yaml"/>'
    add_file(tmp_path / "r.launch", f"<launch>{robot}{load}</launch>".encode())
    found = check(tmp_path / "r.launch", select=["RCT034"]).diagnostics
    assert sum("missing: joint" in one.message for one in found) == count


@pytest.mark.parametrize(
    ("name", "count"),
    [("/$(arg car)/wheel/joint", 0), ("wheel/joint", 0), ("wheel/pid/p", 1), ("hinge/joint", 1)],
)
def test_a_joint_that_the_launch_file_names(tmp_path: Path, name: str, count: int) -> None:
    """F1TENTH: cars share a file of controllers, and each names its joints with a prefix."""
    kind = "type: effort_controllers/JointVelocityController"
    add_file(tmp_path / "c.yaml", f"wheel:\n  {kind}\n  pid: {{p: 9}}\n".encode())
    add_file(tmp_path / "r.urdf", whole_robot(ROBOT).encode())
    text = '<arg name="car" default="car_1"/><rosparam file="$(dirname)/c.yaml"/>'
    text += f"<param name='{name}' value='swing'/>"
    text += '<param name="robot_description" textfile="$(dirname)/r.urdf"/>'
    add_file(tmp_path / "r.launch", f"<launch>{text}</launch>".encode())
    found = check(tmp_path / "r.launch", select=["RCT034"]).diagnostics
    assert sum("missing: joint" in one.message for one in found) == count


@pytest.mark.parametrize(("above", "count"), [("      ros__parameters:\n  ", 0), ("", 1)])
def test_a_type_below_a_second_ros_parameters(tmp_path: Path, above: str, count: int) -> None:
    """panda_ros2_gazebo, whose spawner has the type: no controller is 'drive.ros__parameters'."""
    text = driving.DRIVE.replace("      type: diff", f"{above}      type: dif")
    found = driving.reported(tmp_path, "RCT034", text)
    assert [one.message.partition(":")[0] for one in found] == ["controller 'drive'"] * count


@pytest.mark.parametrize(
    ("name", "count"),
    [("gazebo_ros2_control", 0), ("gazebo_ros_control", 0), ("gazebo_ros_p3d", 1)],
)
def test_a_control_plugin_that_an_argument_adds(name: str, count: int) -> None:
    """LimX: `use_gazebo`, false by default; the transmissions are for ROS 1."""
    drive = plugin("libgazebo_ros_planar_move.so", "<commandTopic>cmd_vel</commandTopic>")
    added = f'<xacro:if value="$(arg s)">{plugin(f"lib{name}.so")}</xacro:if>'
    parts = (ROBOT, transmission("swing"), drive, added)
    text = xacro_xml('<xacro:arg name="s" default="false"/>', *parts).encode()
    found = reported("RCT010", text, "robot.urdf.xacro", ("classic-ros1",))
    assert len(found) == count
