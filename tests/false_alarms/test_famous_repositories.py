"""Robots and launch files of vendors and of ROS itself that are right."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming
from tests.workspaces import add_file, add_package
from urdfkit import check

_PROGRAM = """\
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, ExecuteProcess, GroupAction, OpaqueFunction
from launch.conditions import IfCondition, LaunchConfigurationEquals
from launch.substitutions import LaunchConfiguration, PythonExpression
from launch_ros.actions import Node


def generate_launch_description():
    transport = LaunchConfiguration("transport")
    return LaunchDescription([DeclareLaunchArgument("transport", default_value="serial"), {}])
"""
_AGENT = (
    'Node({}package="micro_ros_agent", executable="micro_ros_agent", '
    'arguments=[transport, "--port", "8888"])'
)
_IS_UDP = "IfCondition(PythonExpression([\"'\", transport, \"' == 'udp4'\"]))"


@pytest.mark.parametrize(
    ("action", "count"),
    [
        (_AGENT.format(""), 1),
        (_AGENT.format(f"condition={_IS_UDP}, "), 0),
        (_AGENT.format('condition=LaunchConfigurationEquals("transport", "udp4"), '), 0),
        (_AGENT.format('condition=LaunchConfigurationEquals("transport", "serial"), '), 1),
        (f"GroupAction(condition={_IS_UDP}, actions=[{_AGENT.format('')}])", 0),
    ],
)
def test_a_node_of_another_choice_than_the_default(tmp_path: Path, action: str, count: int) -> None:
    """linorobot2: the agent of micro-ROS gets the transport by which it is chosen."""
    text = _PROGRAM.format(action)
    assert len(reported(tmp_path / "arm", "LAU036", "a.launch.py", text)) == count


_MANAGER = """\
def setup(context):
    namespace = LaunchConfiguration("namespace")
    name = namespace.perform(context)
    if name == "":
        option = ""
    else:
        option = " -c /" + name + "/controller_manager"
    spawner = "ros2 run controller_manager spawner joint_state_broadcaster"
    return [
        Node(package="controller_manager", executable="ros2_control_node", namespace=namespace),
        ExecuteProcess(cmd=[spawner, {}], shell=True),
    ]


def generate_launch_description():
    argument = DeclareLaunchArgument("namespace", default_value="rarm")
    return LaunchDescription([argument, OpaqueFunction(function=setup)])
"""


@pytest.mark.parametrize(("option", "count"), [("option", 0), ('"--unload-on-kill"', 1)])
def test_a_manager_in_a_part_of_a_command_that_is_known_at_run_time(
    tmp_path: Path, option: str, count: int
) -> None:
    """FANUC's driver: fanuc_mock_control.launch.py."""
    text = _PROGRAM.partition("def")[0] + _MANAGER.format(option)
    found = reported(tmp_path / "arm", "LAU022", "a.launch.py", text)
    assert (
        sum(
            one.message == naming("/controller_manager", "/rarm/controller_manager")
            for one in found
        )
        == count
    )


def test_configurations_of_buses_that_a_macro_installs(tmp_path: Path) -> None:
    """ros2_canopen: ``cogen_dcf`` of lely_core_libraries installs ``config/<bus>``."""
    package = add_package(tmp_path / "arm", "arm")
    add_file(package / "config" / "can" / "arm.eds", b"")
    plugin = '<gazebo><plugin name="p" filename="package://arm/config/can/arm.eds"/></gazebo>'
    text = f'<robot name="arm"><link name="a"/>{plugin}</robot>'.encode()
    robot = add_file(package / "urdf" / "arm.urdf", text)
    build = "project(arm)\n{}install(DIRECTORY urdf DESTINATION share/${{PROJECT_NAME}})\n"
    for macro, count in (("", 1), ("cogen_dcf(can)\n", 0)):
        (package / "CMakeLists.txt").write_text(build.format(macro))
        assert len(check(robot, select=["PKG002"]).diagnostics) == count


@pytest.mark.parametrize(("passed", "count"), [("", 1), (" name:=ur", 0)])
def test_a_name_that_a_launch_file_passes_to_another_robot(
    tmp_path: Path, passed: str, count: int
) -> None:
    """ur_description: an argument of view_ur.launch.py chooses ur_mocked.urdf.xacro."""
    robot = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="$(arg name)">'
        '<xacro:arg name="name" default="ur"/><link name="$(arg kind)"/></robot>'
    )
    package = add_package(tmp_path / "arm", "arm")
    for name in ("arm.xacro", "mocked.xacro"):
        add_file(package / "urdf" / name, robot)
    command = f"xacro $(find arm)/urdf/arm.xacro kind:=a{passed}"
    text = f'<launch><param name="robot_description" command="{command}"/></launch>'
    add_file(package / "launch" / "a.launch", text)
    found = check(package / "urdf" / "mocked.xacro", select=["XAC020"]).diagnostics
    assert len(found) == count
