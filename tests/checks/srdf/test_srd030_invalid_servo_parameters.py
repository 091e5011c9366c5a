"""SRD030: see the rule."""

from pathlib import Path

import pytest

from tests.naming import naming
from tests.srdfs import findings
from urdfkit import Severity

GROUP = '<group name="arm"><chain base_link="base" tip_link="hand"/></group>'
VIRTUAL = '<virtual_joint name="v" type="fixed" parent_frame="world" child_link="base"/>'
SERVO = """\
servo_node:
  ros__parameters:
    moveit_servo:
      move_group_name: arm
      planning_frame: base
      ee_frame_name: hand
      command_out_topic: /arm_controller/joint_trajectory
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm_controller: {type: joint_trajectory_controller/JointTrajectoryController}
    states: {type: joint_state_broadcaster/JointStateBroadcaster}
arm_controller: {ros__parameters: {joints: [shoulder]}}
"""


def messages(
    directory: Path, text: str, body: str = GROUP, controllers: str = "", manifest: str = ""
) -> list[str]:
    (directory / "servo_config.yaml").write_text(text)
    (directory / "ros2_controllers.yaml").write_text(controllers)
    (directory / "package.xml").write_text(f"<package><name>r</name>{manifest}</package>")
    return [found.message for found in findings(directory, body, "SRD030")]


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("", "", ""),
        ("name: arm", "name: panda_arm", "unknown move_group_name 'panda_arm'"),
        ("frame: base", "frame: panda_link0", "unknown planning_frame 'panda_link0'"),
        ("frame: base", "frame: world", "unknown planning_frame 'world'"),
        ("frame: base", "frame: $(var frame)", ""),
        ("ee_frame_name: hand", "ee_frame_name: tool", "unknown ee_frame_name 'tool'"),
        ("ee_frame_name: hand", "other_frame: tool", ""),
        ("command_out_topic", "out_topic", ""),  # a file of another program
    ],
)
def test_groups_and_frames(tmp_path: Path, old: str, new: str, words: str) -> None:
    found = messages(tmp_path, SERVO.replace(old, new))
    assert [words in one for one in found] == [True] * bool(words)


def test_the_frame_of_a_virtual_joint(tmp_path: Path) -> None:
    assert messages(tmp_path, SERVO.replace("frame: base", "frame: world"), GROUP + VIRTUAL) == []


@pytest.mark.parametrize(
    ("topic", "controllers", "count"),
    [
        ("/arm_controller/joint_trajectory", CONTROLLERS, 0),
        ("~/arm_controller/joint_trajectory", CONTROLLERS, 0),
        ("/panda_arm_controller/joint_trajectory", CONTROLLERS, 1),
        ("panda_arm_controller/commands", CONTROLLERS, 1),
        ("/panda_arm_controller/joint_trajectory", "", 0),  # no controller is known
        ("/servo/out", CONTROLLERS, 0),
    ],
)
def test_controllers(tmp_path: Path, topic: str, controllers: str, count: int) -> None:
    text = SERVO.replace("/arm_controller/joint_trajectory", topic)
    found = messages(tmp_path, text, controllers=controllers)
    words = naming("command_out_topic", "panda_arm_controller")
    assert [one.partition(",")[0] for one in found] == [words] * count


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("publish_period: 0.01", ""),
        ("publish_period: 1", "publish_period is an integer"),
        ("publish_period: 0.0", "publish_period is 0.0, must be > 0"),
        ("scale: {linear: 1}", "linear is an integer"),
        ("check_collisions: 1", "check_collisions is an integer"),
        ("command_in_type: speed_unit", "command_in_type is 'speed_unit'"),
        ("command_in_type: speed_units", ""),
    ],
)
def test_values(tmp_path: Path, text: str, words: str) -> None:
    kind = "<export><build_type>ament_cmake</build_type></export>"
    found = messages(tmp_path, f"{SERVO}      {text}\n", manifest=kind)
    assert [words in one for one in found] == [True] * bool(words)


def test_integers_in_ros_1(tmp_path: Path) -> None:
    kind = "<buildtool_depend>catkin</buildtool_depend>"
    assert messages(tmp_path, f"{SERVO}      publish_period: 1\n", manifest=kind) == []


def test_the_group_is_required(tmp_path: Path) -> None:
    text = SERVO.replace(
        "move_group_name: arm", "command_out_type: trajectory_msgs/JointTrajectory"
    )
    (found,) = messages(tmp_path, text)
    assert "move_group_name is missing" in found


TYPED = "move_group_name: arm\ncommand_out_topic: {}\ncommand_out_type: {}\n"


@pytest.mark.parametrize(
    ("topic", "kind", "count"),
    [
        ("/c/joint_trajectory", "std_msgs/Float64MultiArray", 1),
        ("/c/joint_trajectory", "trajectory_msgs/JointTrajectory", 0),
        ("/c/my_ectory", "std_msgs/Float64MultiArray", 0),
    ],
)
def test_types_of_commands(tmp_path: Path, topic: str, kind: str, count: int) -> None:
    (tmp_path / "servo.yaml").write_text(TYPED.format(topic, kind))
    found = findings(tmp_path, GROUP, "SRD030")
    assert [(one.span.line, one.severity, one.help) for one in found] == [
        (3, Severity.WARNING, "write trajectory_msgs/JointTrajectory")
    ] * count
    words = naming("servo.yaml", "command_out_type", kind, topic, "trajectory_msgs/JointTrajectory")
    assert [one.message for one in found] == [words] * count


TWO_CONTROLLERS = """\
controller_manager:
  ros__parameters:
    c: {type: joint_trajectory_controller/JointTrajectoryController}
    f: {type: forward_command_controller/ForwardCommandController}
"""


@pytest.mark.parametrize(
    ("topic", "read"),
    [
        ("/c/command", "/c/joint_trajectory"),
        ("/robot/c/commands", "/robot/c/joint_trajectory"),
        ("f/joint_trajectory", "f/commands"),
        ("/f/commands", ""),
        ("/other/command", ""),
        ("joint_trajectory", ""),
    ],
)
def test_a_topic_of_servo_that_its_controller_does_not_read(
    tmp_path: Path, topic: str, read: str
) -> None:
    text = f"move_group_name: arm\ncommand_out_topic: {topic}\n"
    found = messages(tmp_path, text, controllers=TWO_CONTROLLERS)
    assert found == ([naming("servo_config.yaml", topic, read)] if read else [])
