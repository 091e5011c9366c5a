"""Controllers whose type and whose parameters are in different files, which a spawner loads."""

from pathlib import Path

import pytest

from tests.launched import MANIFEST
from tests.workspaces import add_files
from urdfkit import Diagnostic, check

ROBOT = """<robot name="r"><link name="base"/><link name="arm"/>
<joint name="elbow" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint>
<ros2_control name="c" type="system"><hardware><plugin>mock_components/GenericSystem</plugin>
</hardware><joint name="elbow"><command_interface name="position"/>
<state_interface name="position"/></joint></ros2_control></robot>"""
TYPES = """controller_manager:
  ros__parameters:
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
"""
OWN = """/**:
  arm_controller:
    ros__parameters:
      {}: [elbow]
      command_interfaces: [{}]
      state_interfaces: [position]
"""
LAUNCH = """<launch>
<node pkg="robot_state_publisher" exec="robot_state_publisher">
<param name="robot_description" value="$(command 'cat $(find-pkg-share arm)/r.urdf')"/></node>
<node pkg="controller_manager" exec="ros2_control_node">
<param from="$(find-pkg-share arm)/types.yaml"/></node>
<node pkg="controller_manager" exec="spawner"
args="arm_controller --param-file $(find-pkg-share arm)/own.yaml"/>
</launch>"""


def reported(directory: Path, code: str, own: str, more: str = "") -> list[Diagnostic]:
    files = {"package.xml": MANIFEST, "r.urdf": ROBOT, "types.yaml": TYPES, "own.yaml": own}
    launch = LAUNCH.replace("</launch>", f"{more}</launch>")
    add_files(directory, {**files, "launch/a.launch.xml": launch})
    return list(check(directory / "launch" / "a.launch.xml", select=[code]).diagnostics)


@pytest.mark.parametrize(
    ("code", "joints", "interface", "line"),
    [
        ("RCT021", "joints", "effort", 4),
        ("RCT021", "joints", "position", 0),
        ("RCT001", "joints", "position", 0),
        ("RCT034", "jointz", "position", 2),
    ],
)
def test_parameters_in_the_file_of_a_spawner(
    tmp_path: Path, code: str, joints: str, interface: str, line: int
) -> None:
    found = reported(tmp_path, code, OWN.format(joints, interface))
    assert {Path(one.span.source.path).name for one in found} <= {"own.yaml"}
    assert (found[0].span.line if found else 0) == line


def test_an_unknown_joint(tmp_path: Path) -> None:
    own = OWN.format("joints", "position").replace("elbow", "knee")
    (found,) = reported(tmp_path, "RCT001", own)
    assert (Path(found.span.source.path).name, found.span.text) == ("own.yaml", "knee")


def test_two_files_with_parameters(tmp_path: Path) -> None:
    """Which of them is loaded is unknown: one may be for simulation."""
    add_files(tmp_path, {"other.yaml": OWN.format("joints", "velocity")})
    more = """<node pkg="controller_manager" exec="spawner"
    args="arm_controller --param-file $(find-pkg-share arm)/other.yaml"/>"""
    assert reported(tmp_path, "RCT021", OWN.format("joints", "effort"), more) == []
