from pathlib import Path

import pytest

from tests.controls import (
    GZ,
    ROBOT,
    control,
    controller,
    driven,
    plugin,
    reported_with_file,
)
from tests.naming import naming
from urdfkit import Diagnostic, check
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.diagnostic import Severity


def reported(directory: Path, text: str, blocks: str = "") -> list[Diagnostic]:
    return reported_with_file("RCT001", directory, text, blocks)


def test_a_misspelt_joint(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, controller("arm", joints="[swing, slied]"))
    assert found.message == naming("arm", "unknown", "slied", "slide")
    assert found.span.source.path == str(tmp_path / "c.yaml")
    assert (found.span.line, found.span.text) == (4, "slied")
    (related,) = found.related
    assert related.span.source.path == str(tmp_path / "r.urdf")


def test_every_parameter_that_names_joints(tmp_path: Path) -> None:
    for kind, parameter in [
        ("forward_command_controller/ForwardCommandController", "joints"),
        ("position_controllers/GripperActionController", "joint"),
        ("diff_drive_controller/DiffDriveController", "left_wheel_names"),
        ("tricycle_controller/TricycleController", "traction_joint_name"),
        ("ackermann_steering_controller/AckermannSteeringController", "steering_joints_names"),
        ("mecanum_drive_controller/MecanumDriveController", "front_left_wheel_command_joint_name"),
    ]:
        (found,) = reported(tmp_path, controller("c", kind, **{parameter: "swnig"}))
        assert found.message == naming("c", "unknown", "swnig", "swing")
        assert reported(tmp_path, controller("c", kind, **{parameter: "swing"})) == []


def test_names_that_are_not_joints(tmp_path: Path) -> None:
    forward = "forward_command_controller/ForwardCommandController"
    gpio = control(driven("swing"), '<gpio name="lamp"/>', plugin=GZ)
    assert reported(tmp_path, controller("c", forward, joints="[swing, lamp]"), gpio) == []
    assert reported(tmp_path, controller("c", forward, joints="[swing, pid/swnig]")) == []
    assert reported(tmp_path, controller("c", forward, joints="[swing, '$(var p)arm']")) == []
    assert reported(tmp_path, controller("c", "acme/Own", joints="[swing, swnig]")) == []
    broadcaster = "joint_state_broadcaster/JointStateBroadcaster"
    assert reported(tmp_path, controller("c", broadcaster, extra_joints="[free]")) == []


def test_a_controller_of_another_variant(tmp_path: Path) -> None:
    arm, lift = controller("a", joints="[swing]"), controller("l", joints="[mast, boom]")
    assert reported(tmp_path, arm + lift) == []
    assert len(reported(tmp_path, lift)) == 2, "none of them is for this robot"
    assert len(reported(tmp_path, arm + controller("l", joints="[mast, slide]"))) == 1


def test_a_variant_with_prefixes(tmp_path: Path) -> None:
    assert reported(tmp_path, controller("a", joints="[left_swing, left_slide]")) == []
    assert reported(tmp_path, controller("a", joints="[wing, lide]")) == [], "without its prefix"
    (found,) = reported(tmp_path, controller("a", joints="[swing, left_slide]"))
    assert found.span.text == "left_slide", "the other one is of this robot"


ROS1 = "/robot:\n  arm:\n    type: effort_controllers/JointPositionController\n    joint: swnig\n"


def test_the_files_of_a_launch_file_of_ros_1(tmp_path: Path) -> None:
    (tmp_path / "c.yaml").write_text(ROS1)
    (tmp_path / "r.urdf").write_text(whole_robot(ROBOT))
    (tmp_path / "r.launch").write_text(
        '<launch>\n<rosparam command="load" file="$(dirname)/c.yaml"/>\n'
        '<param name="robot_description" textfile="$(dirname)/r.urdf"/>\n</launch>\n'
    )
    (found,) = check(tmp_path / "r.launch", select=["RCT001"]).diagnostics
    assert found.message == naming("arm", "unknown", "swnig", "swing")
    assert found.severity is Severity.WARNING, "the hardware may have joints of its own"
    assert found.span.source.path == str(tmp_path / "c.yaml")
    (related,) = found.related
    assert related.span.source.path == str(tmp_path / "r.launch")
    assert related.span.line == 2
    assert check(tmp_path / "r.urdf", select=["RCT001"]).diagnostics == ()
    simulated = whole_robot(ROBOT + plugin("libgazebo_ros_control.so"))
    (tmp_path / "r.urdf").write_text(simulated)
    (found,) = check(tmp_path / "r.launch", select=["RCT001"]).diagnostics
    assert found.severity is Severity.ERROR, "Gazebo has no joints but those of the model"


def test_the_files_of_a_launch_file_in_python(tmp_path: Path) -> None:
    (tmp_path / "c.yaml").write_text(controller("arm", joints="[swing, slied]"))
    (tmp_path / "r.urdf").write_text(whole_robot(ROBOT))
    (tmp_path / "r.launch.py").write_text(
        "import os\nfrom launch_ros.actions import Node\n"
        f"directory = {str(tmp_path)!r}\n"
        "robot = Command(['cat ', os.path.join(directory, 'r.urdf')])\n"
        "controllers = os.path.join(directory, 'c.yaml')\n"
        "node = Node(package='controller_manager', executable='ros2_control_node',\n"
        "            parameters=[{'robot_description': robot}, controllers])\n"
    )
    (found,) = check(tmp_path / "r.launch.py", select=["RCT001"]).diagnostics
    assert "'slied'" in found.message
    assert found.related[0].span.text == "controllers"


def test_a_joint_with_one_word_more_or_less(tmp_path: Path) -> None:
    """Its controller is the only one of the file without a joint of the robot."""
    arm = controller("a", joints="[swing]")
    (found,) = reported(tmp_path, arm + controller("l", joints="[slide_joint]"))
    assert found.message == naming("l", "unknown", "slide_joint", "slide")
    assert (
        reported(tmp_path, arm + controller("l", joints="[swing_joint]")) == []
    )  # swing is driven
    assert reported(tmp_path, arm + controller("l", joints="[slidebar]")) == []


@pytest.mark.parametrize(
    ("driven", "joint", "count"),
    [
        ("abc", "elbow", 1),
        ("ab", "elbow", 0),  # two joints have no controller
        ("abc", "elbow, wrist", 0),
        ("abcd", "elbow", 0),  # each has one
    ],
)
def test_the_only_joint_without_a_controller(
    tmp_path: Path, driven: str, joint: str, count: int
) -> None:
    """Of ROBOTIS OP3, each of the twenty joints has a controller of its own."""
    links = "".join(f'<link name="{name}_link"/>' for name in "abcd")
    joints = "".join(
        f'<joint name="{name}" type="continuous"><parent link="base"/>'
        f'<child link="{name}_link"/></joint>'
        for name in "abcd"
    )
    arms = "".join(controller(f"{name}_controller", joints=f"[{name}]") for name in driven)
    text = arms + controller("last", joints=f"[{joint}]")
    robot = f'<link name="base"/>{links}{joints}'
    found = reported_with_file("RCT001", tmp_path, text, "", robot)
    assert [one.message for one in found] == [naming("last", "unknown", "elbow", "d")] * count


@pytest.mark.parametrize(
    ("names", "found"),
    [
        (("Index", "Middle", "Ring", "Pinky", "Thumb"), []),
        (("Index", "Middle", "Ring", "Little", "Thumb"), ["Left_Little"]),
        (("Index", "Middle", "Small", "Little", "Thumb"), []),  # another hand
        (("Index", "Middle", "Little"), []),
    ],
)
def test_a_controller_of_the_other_side(
    tmp_path: Path, names: tuple[str, ...], found: list[str]
) -> None:
    """SCHUNK's SVH: an argument chooses the hand, and the file has a controller for each."""
    joints = [f"Right_{name}" for name in ("Index", "Middle", "Ring", "Pinky", "Thumb")]
    robot = '<link name="base"/>' + "".join(
        f'<link name="{name}_l"/><joint name="{name}" type="continuous"><parent link="base"/>'
        f'<child link="{name}_l"/></joint>'
        for name in joints
    )
    text = controller("right", joints=f"[{', '.join(joints)}]")
    text += controller("left", joints=f"[{', '.join(f'Left_{name}' for name in names)}]")
    heard = reported_with_file("RCT001", tmp_path, text, "", robot)
    assert [one.span.text for one in heard] == found
    assert [one.message for one in heard] == [naming("left", "4", name) for name in found]
    assert all(one.severity is Severity.WARNING for one in heard)
