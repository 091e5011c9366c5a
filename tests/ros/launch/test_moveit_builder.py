"""Robots and controllers of launch files with ``MoveItConfigsBuilder``."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from urdfkit import check

ROBOT = """\
<robot name="arm">
  <link name="base"/><link name="upper_arm"/>
  <joint name="shoulder" type="revolute"><parent link="base"/><child link="upper_arm"/>
    <axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="9" velocity="1"/></joint>
  <joint name="tip" type="fixed"><parent link="upper_arm"/><child link="tool"/></joint>
  <link name="tool"/>
</robot>
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arm: {ros__parameters: {joints: [shoulder, elbow]}}
"""
BUILDER = 'config = MoveItConfigsBuilder("arm"{}){}.to_moveit_configs()\n'
NODE = "Node(package='controller_manager', executable='ros2_control_node', parameters=[{}])\n"
IN_PACKAGE = "config.robot_description, config.package_path / 'config/control.yaml'"


@pytest.mark.parametrize(
    ("builder", "parameters", "count"),
    [
        (BUILDER.format("", ""), IN_PACKAGE, 1),
        (BUILDER.format("", ""), "str(config.package_path / 'config/control.yaml')", 1),
        (BUILDER.format(", package_name='arm_moveit_config'", ""), IN_PACKAGE, 1),
        (
            BUILDER.format("", ".robot_description(file_path='config/arm.urdf.xacro')"),
            IN_PACKAGE,
            1,
        ),
        (BUILDER.format("", ".robot_description('config/other.urdf.xacro')"), IN_PACKAGE, 0),
        (BUILDER.format(", package_name=name", ""), IN_PACKAGE, 0),
        (BUILDER.format("", ""), "config.robot_description", 0),
    ],
)
def test_controllers_of_a_launch_file(
    tmp_path: Path, builder: str, parameters: str, count: int
) -> None:
    package = add_package(tmp_path / "arm_moveit_config", "arm_moveit_config")
    add_file(package / "config" / "arm.urdf.xacro", ROBOT)
    add_file(package / "config" / "control.yaml", CONTROLLERS)
    add_file(package / "launch" / "arm.launch.py", builder + NODE.format(parameters))
    found = check(tmp_path, select=["RCT001"]).diagnostics
    assert [(one.span.line, one.span.text) for one in found] == [(4, "elbow")] * count


@pytest.mark.parametrize(
    ("of_robot", "of_srdf", "count"),
    [
        ("{'arm_prefix': 'a_'}", "{'arm_prefix': 'a'}", 1),
        ("{'prefix': 'a_'}", "{'prefix': 'a_'}", 0),
        ("{'prefix': 'a_'}", "{'prefix': side}", 0),
        ("{'prefix': 'a_'}", "{}", 0),
        ("{'name': 'a'}", "{'name': 'b'}", 0),  # the name of a robot, and of a group
    ],
)
def test_prefixes_of_the_robot_and_of_the_srdf(
    tmp_path: Path, of_robot: str, of_srdf: str, count: int
) -> None:
    package = add_package(tmp_path / "arm_moveit_config", "arm_moveit_config")
    files = f".robot_description('a.urdf.xacro', {of_robot})"
    files += f".robot_description_semantic('a.srdf.xacro', mappings={of_srdf})"
    add_file(package / "launch" / "arm.launch.py", BUILDER.format("", files))
    found = check(tmp_path, select=["LAU029"]).diagnostics
    assert [one.span.text for one in found if "the SRDF gets" in one.message] == ["'a'"] * count
