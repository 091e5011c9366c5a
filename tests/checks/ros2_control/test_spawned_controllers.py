"""Controllers that launch files start with a robot whose joints have another prefix."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from tests.workspaces import add_files
from urdfkit import check

ROBOT = """<robot name="r" xmlns:xacro="http://wiki.ros.org/xacro">
<xacro:arg name="prefix" default="arm_"/><link name="base"/><link name="a"/><link name="b"/>
<joint name="$(arg prefix)elbow" type="continuous"><parent link="base"/><child link="a"/>
<axis xyz="0 0 1"/></joint>
<joint name="$(arg prefix)finger" type="continuous"><parent link="a"/><child link="b"/>
<axis xyz="0 0 1"/></joint></robot>"""
CONTROLLERS = """controller_manager:
  ros__parameters:
    arm: {type: forward_command_controller/ForwardCommandController}
    hand: {type: position_controllers/GripperActionController}
arm:
  ros__parameters: {joints: [arm_elbow], interface_name: position}
hand:
  ros__parameters: {joint: finger}
"""
LAUNCH = """<launch><arg name="prefix" default="arm_"/>
<node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description"
value="$(command 'xacro $(find-pkg-share arm)/r.xacro prefix:=PREFIX')"/></node>
<node pkg="controller_manager" exec="ros2_control_node">
<param from="$(find-pkg-share arm)/c.yaml"/></node>
<node pkg="controller_manager" exec="spawner" args="arm hand"/></launch>"""


@pytest.mark.parametrize(
    ("launch", "count"),
    [
        (LAUNCH.replace("PREFIX", "arm_"), 1),
        (LAUNCH.replace("PREFIX", "$(var prefix)"), 1),
        (LAUNCH.replace("PREFIX", "$(env PREFIX)"), 0),  # any prefix
        (LAUNCH.replace("PREFIX", "arm_").replace("arm hand", "arm"), 0),  # of another robot
    ],
)
def test_a_joint_without_the_prefix_of_the_robot(tmp_path: Path, launch: str, count: int) -> None:
    files = {"package.xml": MANIFEST, "r.xacro": ROBOT, "c.yaml": CONTROLLERS}
    add_files(tmp_path, {**files, "launch/a.launch.xml": launch})
    found = check(tmp_path, select=["RCT001"]).diagnostics
    assert [one.span.text for one in found] == ["finger"] * count
    assert all("did you mean 'arm_finger'?" in one.message for one in found)


def test_a_robot_that_has_the_joint_with_other_arguments(tmp_path: Path) -> None:
    """One launch file starts the controllers with one prefix, another without."""
    add_files(
        tmp_path,
        {
            "package.xml": MANIFEST,
            "r.xacro": ROBOT,
            "c.yaml": CONTROLLERS,
            "launch/a.launch.xml": LAUNCH.replace("PREFIX", "arm_"),
            "launch/b.launch.xml": LAUNCH.replace("PREFIX", ""),
        },
    )
    found = check(tmp_path, select=["RCT001"]).diagnostics
    assert "finger" not in [one.span.text for one in found]
