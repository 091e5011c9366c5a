"""SRD029: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import Severity, check

MANIFEST = b"""<package format="3"><name>p</name>
<export><build_type>ament_cmake</build_type></export></package>"""
ROBOT = b"""<robot name='r'><link name='base'/><link name='l'/><link name='f'/>
<joint name='j' type='continuous'><parent link='base'/><child link='l'/></joint>
<joint name='g' type='continuous'><parent link='l'/><child link='f'/></joint></robot>"""
SRDF = b"<robot name='r'><group name='arm'><joint name='j'/></group></robot>"
MOVEIT = b"""\
moveit_controller_manager: moveit_simple_controller_manager/MoveItSimpleControllerManager
moveit_simple_controller_manager:
  controller_names: [arm, hand]
  arm:
    {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [j]}
  hand:
    {type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [g]}
"""
CONTROL = """\
controller_manager:
  ros__parameters:
    arm: {{type: joint_trajectory_controller/JointTrajectoryController}}
    {}: {{type: joint_trajectory_controller/JointTrajectoryController}}
"""
SPAWNER = "Node(package='controller_manager', executable='spawner', arguments=[{}])\n"
DRIVER = """
IncludeLaunchDescription(PythonLaunchDescriptionSource(
    get_package_share_directory('acme_driver') + '/launch/driver.launch.py'))
"""
ARM = SPAWNER.format("'arm'")


@pytest.mark.parametrize(("name", "count"), [("/robot/hand", 0), ("/robot/claw", 1)])
def test_a_controller_in_a_namespace(tmp_path: Path, name: str, count: int) -> None:
    """One of two robots in Gazebo: MoveIt calls the action /robot/hand/follow_joint_trajectory."""
    moveit = MOVEIT.replace(b"[arm, hand]", b"[arm, %s]" % name.encode())
    moveit = moveit.replace(b"  hand:", b"  %s:" % name.encode())
    control = CONTROL.format("hand") + "hand: {ros__parameters: {joints: [g]}}\n"
    add_file(tmp_path / "package.xml", MANIFEST)
    path = add_file(tmp_path / "r.urdf", ROBOT)
    add_file(tmp_path / "config" / "r.srdf", SRDF)
    add_file(tmp_path / "config" / "moveit_controllers.yaml", moveit)
    add_file(tmp_path / "config" / "ros2_controllers.yaml", control.encode())
    found = check(path, select=["SRD029"]).diagnostics
    assert [one.span.text for one in found] == [name] * count


@pytest.mark.parametrize(
    ("launch", "defined", "count"),
    [
        (ARM, "hand", 1),
        (SPAWNER.format("'arm', 'hand'"), "hand", 0),
        (ARM + SPAWNER.format("'hand'"), "hand", 0),
        (ARM + "# spawn hand by hand\n", "hand", 0),
        (ARM + SPAWNER.format("os.environ['HELD']"), "hand", 0),
        (ARM + "generate_demo_launch(config)\n", "hand", 0),
        (ARM + DRIVER, "hand", 0),
        (SPAWNER.format("'joints'"), "hand", 0),  # the spawner of another robot
        (ARM, "other", 0),  # a driver may serve it
    ],
)
def test_a_controller_that_nothing_spawns(
    tmp_path: Path, launch: str, defined: str, count: int
) -> None:
    add_file(tmp_path / "package.xml", MANIFEST)
    path = add_file(tmp_path / "r.urdf", ROBOT)
    add_file(tmp_path / "config" / "r.srdf", SRDF)
    add_file(tmp_path / "config" / "moveit_controllers.yaml", MOVEIT)
    add_file(tmp_path / "config" / "ros2_controllers.yaml", CONTROL.format(defined).encode())
    add_file(tmp_path / "launch" / "r.launch.py", launch.encode())
    found = check(path, select=["SRD029"]).diagnostics
    assert [(one.span.line, one.span.text) for one in found] == [(6, "hand")] * count


def test_a_broadcaster_commands_no_joints(tmp_path: Path) -> None:
    """DanielMilstein/yahboom_rosmaster_x3plus: it has a list of joints, and stands first."""
    states = "    states: {type: joint_state_broadcaster/JointStateBroadcaster}\n"
    lists = "states: {ros__parameters: {joints: [j, g]}}\nclaw: {ros__parameters: {joints: [g]}}\n"
    control = CONTROL.format("claw").replace("    arm:", f"{states}    arm:") + lists
    add_file(tmp_path / "package.xml", MANIFEST)
    path = add_file(tmp_path / "r.urdf", ROBOT)
    add_file(tmp_path / "config" / "r.srdf", SRDF)
    add_file(tmp_path / "config" / "moveit_controllers.yaml", MOVEIT)
    add_file(tmp_path / "config" / "ros2_controllers.yaml", control.encode())
    found = check(path, select=["SRD029"]).diagnostics
    assert [(one.span.text, "'claw'" in one.message) for one in found] == [("hand", True)]


def test_a_controller_without_a_type(tmp_path: Path) -> None:
    moveit = MOVEIT.replace(b"{type: FollowJointTrajectory, ", b"{", 1)
    control = CONTROL.format("hand") + "arm: {ros__parameters: {joints: [j]}}\n"
    add_file(tmp_path / "package.xml", MANIFEST)
    path = add_file(tmp_path / "r.urdf", ROBOT)
    add_file(tmp_path / "config" / "r.srdf", SRDF)
    add_file(tmp_path / "config" / "moveit_controllers.yaml", moveit)
    add_file(tmp_path / "config" / "ros2_controllers.yaml", control.encode())
    found = check(path, select=["SRD029"]).diagnostics
    assert [(one.span.text, one.help) for one in found] == [
        ("arm", "write type: FollowJointTrajectory")
    ]


@pytest.mark.parametrize(
    ("kind", "joints", "count"),
    [
        ("position_controllers", "[g]", 0),
        ("position_controllers", "[g, j]", 0),  # with a mimic joint
        ("position_controllers", "[j]", 1),
        ("parallel_gripper_action_controller", "[j]", 1),
        ("acme_controllers", "[j]", 0),
    ],
)
def test_the_joint_of_a_gripper(tmp_path: Path, kind: str, joints: str, count: int) -> None:
    name = "Other" if kind == "acme_controllers" else "GripperActionController"
    kinds = {"parallel_gripper_action_controller": "ParallelGripperCommand"}
    action = f"type: {kinds.get(kind, 'GripperCommand')}, action_ns: gripper_cmd"
    moveit = MOVEIT.decode().replace(
        "type: FollowJointTrajectory, action_ns: follow_joint_trajectory, joints: [g]",
        f"{action}, joints: {joints}",
    )
    control = CONTROL.format("hand").replace(
        "hand: {type: joint_trajectory_controller/JointTrajectoryController}",
        f"hand: {{type: {kind}/{name}}}",
    )
    control += "arm: {ros__parameters: {joints: [j]}}\nhand: {ros__parameters: {joint: g}}\n"
    add_file(tmp_path / "package.xml", MANIFEST)
    path = add_file(tmp_path / "r.urdf", ROBOT)
    add_file(tmp_path / "config" / "r.srdf", SRDF)
    add_file(tmp_path / "config" / "moveit_controllers.yaml", moveit.encode())
    add_file(tmp_path / "config" / "ros2_controllers.yaml", control.encode())
    found = check(path, select=["SRD029"]).diagnostics
    assert [one.message for one in found] == [naming("hand", "ros2_control")] * count
    assert all(one.severity is Severity.WARNING for one in found)
