"""Errors under values of arguments that no launch file starts a robot with."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST, launch
from tests.workspaces import add_file
from urdfkit import Diagnostic, check

HEAD = '<robot name="arm" xmlns:xacro="http://www.ros.org/wiki/xacro">'
LINKS = '<link name="a"/><link name="b"/>'
JOINT = (
    '<joint name="{}" type="prismatic"><parent link="a"/><child link="b"/>'
    '<limit lower="0" upper="1" effort="1" velocity="1"/></joint>'
)
#: IFRA's robot arms: one file for each gripper, and its hardware in that of the argument.
INCLUDE = '<xacro:include filename="tools/$(arg tool)/hardware.xacro"/>'
HARDWARE = (
    f'{HEAD}<ros2_control name="tool" type="system"><hardware>'
    "<plugin>mock_components/GenericSystem</plugin></hardware>"
    '<joint name="{}_joint"><command_interface name="position"/>'
    '<state_interface name="position"/></joint></ros2_control></robot>'
)
START = '<param name="robot_description" command="xacro $(dirname)/../{}.xacro tool:={}"/>'


def arm(package: Path, joint: str, *tools: str) -> None:
    (package / "package.xml").write_text(MANIFEST)
    robot = HEAD + LINKS + JOINT.format(f"{joint}_joint") + INCLUDE + "</robot>"
    add_file(package / "arm.xacro", robot.encode())
    for tool in tools:
        path = package / "tools" / tool / "hardware.xacro"
        add_file(path, HARDWARE.format(tool).encode())


def unknown_joints(package: Path) -> list[Diagnostic]:
    return list(check(package, select=["RCT001"]).diagnostics)


def test_hardware_of_a_directory_that_nobody_may_choose(tmp_path: Path) -> None:
    arm(tmp_path, "hand", "hand", "cup")
    (found,) = unknown_joints(tmp_path)
    assert (found.severity.value, found.confidence.value) == ("info", "guessed")
    assert found.variants == ("tool=cup",)
    assert "'cup_joint'" in found.message


@pytest.mark.parametrize(("robot", "severity"), [("arm", "error"), ("other", "warning")])
def test_the_arguments_of_a_launch_file(tmp_path: Path, robot: str, severity: str) -> None:
    """With this robot the launch file breaks it; with another one nobody may."""
    arm(tmp_path, "hand", "hand", "cup")
    add_file(tmp_path / "other.xacro", f'{HEAD}<link name="$(arg tool)"/></robot>'.encode())
    add_file(tmp_path / "launch" / "a.launch", launch(START.format(robot, "cup")).encode())
    (found,) = unknown_joints(tmp_path)
    assert found.severity.value == severity
    assert found.variants == (("tool=cup",) if severity == "warning" else ())


def test_an_error_with_all_values(tmp_path: Path) -> None:
    """It does not depend on what is chosen."""
    arm(tmp_path, "hand", "hand", "cup")
    robot = (tmp_path / "arm.xacro").read_text()
    own = HARDWARE.format("lost").removeprefix(HEAD).replace('"tool"', '"own"')
    (tmp_path / "arm.xacro").write_text(robot.removesuffix("</robot>") + own)
    found = unknown_joints(tmp_path)
    severities = {one.message.split("'")[-2]: one.severity.value for one in found}
    assert severities == {"cup_joint": "warning", "lost_joint": "error"}


def test_one_value_that_is_there(tmp_path: Path) -> None:
    """There is nothing else to choose."""
    arm(tmp_path, "hand", "cup")
    (found,) = unknown_joints(tmp_path)
    assert (found.severity.value, found.variants) == ("error", ())


@pytest.mark.parametrize(("passed", "severity"), [("tool", "warning"), ("other", "error")])
def test_the_argument_of_one_of_several_robots(tmp_path: Path, passed: str, severity: str) -> None:
    """CynLr_Dual_Arm: the launch file chooses the arm, and passes the argument of its parts."""
    (tmp_path / "package.xml").write_text(MANIFEST)
    hardware = HARDWARE.format("$(arg tool)").removeprefix(HEAD)
    argument = '<xacro:arg name="tool" default="cup"/>'
    robot = HEAD + argument + LINKS + JOINT.format("hand_joint") + hardware
    add_file(tmp_path / "urdf" / "ur5.xacro", robot.encode())
    program = (
        "import os\nimport xacro\nfrom launch import LaunchDescription\n"
        "def generate_launch_description():\n"
        "    path = 'urdf/ur5.xacro' if os.getpid() else 'urdf/panda.xacro'\n"
        f"    robot = xacro.process_file(path, mappings={{'{passed}': 'hand'}}).toxml()\n"
        "    return LaunchDescription([])\n"
    )
    add_file(tmp_path / "launch" / "a.launch.py", program.encode())
    (found,) = unknown_joints(tmp_path)
    assert found.severity.value == severity


@pytest.mark.parametrize(("tools", "count"), [(("cup",), 1), (("cup", "hand"), 0)])
def test_another_value_of_a_switch_with_assumed_arguments(
    tmp_path: Path, tools: tuple[str, ...], count: int
) -> None:
    """IFRA: nobody may start this robot with the controllers of that gripper."""
    arm(tmp_path, "hand", *tools)
    robot = (tmp_path / "arm.xacro").read_text()
    switch = '<xacro:arg name="sim" default="false"/><xacro:if value="$(arg sim)">{}</xacro:if>'
    (tmp_path / "arm.xacro").write_text(
        robot.replace(INCLUDE, f'<gazebo reference="$(arg tool)"/>{switch.format(INCLUDE)}')
    )
    assert [one.variants for one in unknown_joints(tmp_path)] == [("sim=true",)] * count
