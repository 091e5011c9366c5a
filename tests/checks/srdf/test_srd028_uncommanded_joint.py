"""SRD028: a joint of an arm that the controller of MoveIt lacks."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import check

MANIFEST = b"""<package format="3"><name>p</name>
<export><build_type>ament_cmake</build_type></export></package>"""
ROBOT = "<robot name='r'><link name='base'/>" + "".join(
    f"""<link name='l{n}'/><joint name='j{n}' type='revolute'><parent link='{above}'/>
<child link='l{n}'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint>"""
    for n, above in ((1, "base"), (2, "l1"), (3, "l2"), (4, "l3"))
)
SRDF = "<robot name='r'><group name='arm'><chain base_link='base' tip_link='l4'/></group>{}</robot>"
MOVEIT = """\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
moveit_simple_controller_manager:
  controller_names: [arm]
  arm:
    type: FollowJointTrajectory
    action_ns: follow_joint_trajectory
    joints: [{}]
"""
CONTROL = """\
controller_manager:
  ros__parameters:
    arm: {type: joint_trajectory_controller/JointTrajectoryController}
arm:
  ros__parameters: {joints: [j1, j2, j3, j4], allow_partial_joints_goal: true}
"""


def messages(directory: Path, joints: str, srdf: str = "", robot: str = "</robot>") -> list[str]:
    add_file(directory / "package.xml", MANIFEST)
    path = add_file(directory / "r.urdf", (ROBOT + robot).encode())
    add_file(directory / "config" / "r.srdf", SRDF.format(srdf).encode())
    add_file(directory / "config" / "moveit_controllers.yaml", MOVEIT.format(joints).encode())
    add_file(directory / "config" / "ros2_controllers.yaml", CONTROL.encode())
    return [one.message for one in check(path, select=["SRD028"]).diagnostics]


def test_one_is_forgotten(tmp_path: Path) -> None:
    (message,) = messages(tmp_path, "j1, j2, j3")
    assert message == naming("arm", "j4", "arm", "MoveIt")


FINGER = """<link name='f'/><joint name='finger' type='revolute'><parent link='l3'/>
<child link='f'/><limit lower='-1' upper='1' effort='1' velocity='1'/></joint></robot>"""


@pytest.mark.parametrize(
    ("joints", "srdf", "robot"),
    [
        ("j1, j2, j3, j4", "", "</robot>"),
        ("j1, j2", "", "</robot>"),  # another program moves the rest
        ("j1, j2, j3", "<passive_joint name='j4'/>", "</robot>"),
        # a gripper that is driven elsewhere
        ("j1, j2, j3, j4", "<group name='all'><group name='arm'/><link name='f'/></group>", FINGER),
    ],
)
def test_no_finding(tmp_path: Path, joints: str, srdf: str, robot: str) -> None:
    assert messages(tmp_path, joints, srdf, robot) == []
