"""The joints that MoveIt sends to the controllers of ros2_control."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import check

MANIFEST = """<package format="3"><name>p</name>
<export><build_type>ament_cmake</build_type></export></package>"""
LINK = '<link name="{}"/>'
JOINT = '<joint name="{}" type="{}"><parent link="{}"/><child link="{}"/>{}</joint>'
LIMIT = '<limit lower="0" upper="1" effort="1" velocity="1"/>'
ROBOT = f"""<robot name="r">{"".join(map(LINK.format, ["base", "right", "left", "tip"]))}
{JOINT.format("right_finger", "prismatic", "base", "right", LIMIT)}
{JOINT.format("left_finger", "prismatic", "base", "left", LIMIT + '<mimic joint="right_finger"/>')}
{JOINT.format("tip_joint", "fixed", "left", "tip", "")}
</robot>"""
SRDF = """<robot name="r"><virtual_joint name="floor" type="fixed" parent_frame="world"
  child_link="base"/><group name="hand"><joint name="right_finger"/></group></robot>"""
MOVEIT = """\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
moveit_simple_controller_manager:
  controller_names: [hand]
  hand: {{type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [{}]}}
"""
CONTROL = """\
controller_manager:
  ros__parameters:
    hand: {{type: joint_trajectory_controller/JointTrajectoryController}}
hand:
  ros__parameters: {{joints: [{}]}}
"""


@pytest.mark.parametrize(
    ("moveit", "control", "count"),
    [
        ("right_finger, left_finger", "right_finger", 0),  # AntoBrandi's Arduinobot
        ("floor, right_finger, tip_joint", "right_finger", 0),  # a Panda
        ("right_finger, left_finger", "right_finger, left_finger", 0),
        ("right_finger", "right_finger, left_finger", 1),
        ("left_finger", "right_finger", 1),
    ],
)
def test_joints_that_no_trajectory_moves(
    tmp_path: Path, moveit: str, control: str, count: int
) -> None:
    (tmp_path / "package.xml").write_text(MANIFEST)
    robot = add_file(tmp_path / "r.urdf", ROBOT.encode())
    add_file(tmp_path / "config" / "r.srdf", SRDF.encode())
    add_file(tmp_path / "config" / "moveit_controllers.yaml", MOVEIT.format(moveit).encode())
    add_file(tmp_path / "config" / "ros2_controllers.yaml", CONTROL.format(control).encode())
    found = [one.message for one in check(robot, select=["SRD029"]).diagnostics]
    assert ["controller 'hand' has other" in one for one in found] == [True] * count


def test_an_action_that_is_written_is_not_said_to_be_missing(tmp_path: Path) -> None:
    """Another UR5: "the controller has no action_ns 'gripper_action'", at this very text."""
    kind = "position_controllers/GripperActionController"
    (tmp_path / "package.xml").write_text(MANIFEST)
    robot = add_file(tmp_path / "r.urdf", ROBOT.encode())
    add_file(tmp_path / "config" / "r.srdf", SRDF.encode())
    moveit = MOVEIT.format("right_finger").replace("FollowJointTrajectory", "GripperCommand")
    moveit = moveit.replace("follow_joint_trajectory", "gripper_action")
    add_file(tmp_path / "config" / "moveit_controllers.yaml", moveit.encode())
    control = f"controller_manager:\n  ros__parameters:\n    hand: {{type: {kind}}}\n"
    add_file(tmp_path / "config" / "ros2_controllers.yaml", control.encode())
    (found,) = check(robot, select=["SRD029"]).diagnostics
    assert found.message == naming("action_ns", "hand", "gripper_action", kind, "gripper_cmd")
    assert found.help == "write gripper_cmd"
