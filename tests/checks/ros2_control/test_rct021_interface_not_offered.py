"""RCT021: see the rule."""

from pathlib import Path

import pytest

from tests.controls import (
    GZ,
    NEXT,
    ROBOT,
    TRAJECTORY,
    control,
    controller,
    driven,
    plugin,
    reported_with_file,
    transmission,
)
from tests.naming import naming
from tests.reported import messages, places
from urdfkit import Diagnostic, Severity, check
from urdfkit.lint.rule_examples import whole_robot

OFFERED = control(driven("swing", "velocity", "velocity"), driven("slide"), plugin=GZ)


def reported(
    directory: Path, text: str, blocks: str = OFFERED, direction: str = "command"
) -> list[Diagnostic]:
    diagnostics = reported_with_file("RCT021", directory, text, blocks)
    return [found for found in diagnostics if f"requires {direction} interface" in found.message]


def state_reported(directory: Path, text: str) -> list[Diagnostic]:
    return reported(directory, text, direction="state")


def test_command_interfaces_of_a_trajectory_controller(tmp_path: Path) -> None:
    text = controller("arm", joints="[swing, slide]", command_interfaces="[position, acceleration]")
    first, second = reported(tmp_path, text)
    assert first.message == naming("arm", "acceleration", "swing", "velocity")
    assert (first.span.line, first.span.text) == (4, "swing")
    assert second.message == naming("arm", "acceleration", "slide")


def test_a_follower_is_not_commanded(tmp_path: Path) -> None:
    gripper = controller("hand", "parallel_gripper_action_controller/GripperActionController")
    follower = '<joint name="follow"><state_interface name="position"/></joint>'
    blocks = control(driven("swing"), follower, plugin=GZ)
    (found,) = reported(tmp_path, gripper + "    joint: follow\n", blocks)
    assert found.help == naming("swing", "moves")


@pytest.mark.parametrize(
    ("interface", "count"),
    [("swing/velocity", 0), ("swing/effort", 1), ("knuckle/effort", 1), ("effort", 1)],
)
def test_a_further_interface_of_a_gripper(tmp_path: Path, interface: str, count: int) -> None:
    kind = "parallel_gripper_action_controller/GripperActionController"
    text = controller("hand", kind, joint="slide", max_effort_interface=interface)
    assert [one.span.text for one in reported(tmp_path, text)] == [interface] * count


@pytest.mark.parametrize(
    ("joints", "hardware", "count"),
    [
        ("[swing, slide]", GZ, 1),
        ("[swing]", GZ, 0),
        ("[slide]", GZ, 0),  # the controller may be for another variant
        ("[swing, slied]", GZ, 0),  # RCT001 reports it
        ("[swing, slide]", "acme/Motors", 0),
    ],
)
def test_a_joint_that_the_hardware_lacks(
    tmp_path: Path, joints: str, hardware: str, count: int
) -> None:
    text = controller("arm", joints=joints, command_interfaces="[position]")
    found = reported(tmp_path, text, control(driven("swing"), plugin=hardware))
    assert [(one.span.line, one.span.text) for one in found] == [(4, "slide")] * count
    text += controller("reduced", joints="[swing]", command_interfaces="[position]")
    assert reported(tmp_path, text, control(driven("swing"), plugin=hardware)) == []


@pytest.mark.parametrize(
    ("kind", "names", "joint"),
    [
        ("velocity_controllers/JointGroupVelocityController", "joints", "slide"),
        ("effort_controllers/JointGroupEffortController", "joints", "swing"),
        ("position_controllers/JointGroupPositionController", "joints", "swing"),
        ("diff_drive_controller/DiffDriveController", "left_wheel_names", "slide"),
    ],
)
def test_command_interface_of_the_type(tmp_path: Path, kind: str, names: str, joint: str) -> None:
    (found,) = reported(tmp_path, controller("c", kind, **{names: f"[{joint}]"}))
    assert found.span.text == joint
    good = "slide" if joint == "swing" and "effort" not in kind else "swing"
    others = reported(tmp_path, controller("c", kind, **{names: f"[{good}]"}))
    assert len(others) == ("effort" in kind)


def test_unknown_controller_is_accepted(tmp_path: Path) -> None:
    velocity = controller("arm", joints="[swing]", command_interfaces="[position]")
    assert reported(tmp_path, velocity, "") == []  # no block at all
    assert reported(tmp_path, controller("arm", joints="[swing]")) == []
    assert reported(tmp_path, controller("arm", "acme/Own", joints="[swing]")) == []
    other = controller(
        "arm", joints="[swing]", command_joints="[pid/swing]", command_interfaces="[position]"
    )
    assert reported(tmp_path, other) == []
    assert TRAJECTORY in other


@pytest.mark.parametrize(("hardware", "count"), [("acme/Motors", 0), (GZ, 1)])
def test_a_launch_file_that_starts_the_real_robot(
    tmp_path: Path, hardware: str, count: int
) -> None:
    """The Gazebo plugin loads the file of another variant, as in open_manipulator."""
    text = controller("arm", joints="[swing]", command_interfaces="[position]")
    (tmp_path / "gazebo.yaml").write_text(text)
    (tmp_path / "real.yaml").write_text(text.replace("[position]", "[effort]"))
    blocks = control(driven("swing", "effort"), plugin=hardware)
    names = plugin("gz_ros2_control-system", f"<parameters>{tmp_path}/gazebo.yaml</parameters>")
    (tmp_path / "r.urdf").write_text(whole_robot(ROBOT + blocks + names))
    (tmp_path / "r.launch.py").write_text(
        f"robot = Command(['cat ', '{tmp_path}/r.urdf'])\n"
        "Node(package='controller_manager', executable='ros2_control_node',\n"
        f"     parameters=[{{'robot_description': robot}}, '{tmp_path}/real.yaml'])\n"
    )
    assert len(check(tmp_path / "r.launch.py", select=["RCT021"]).diagnostics) == count


DRIVE = "drive:\n  type: {}_controllers/JointPositionController\n  joint: swing\n"


@pytest.mark.parametrize(
    ("text", "count"),
    [
        (DRIVE.format("position"), 1),
        (DRIVE.format("effort"), 0),
        (DRIVE.format("position") + DRIVE.format("effort").replace("drive", "other"), 0),
    ],
)
def test_interfaces_of_transmissions_in_ros_1(tmp_path: Path, text: str, count: int) -> None:
    (tmp_path / "c.yaml").write_text(text)
    robot = ROBOT + transmission("swing") + plugin("libgazebo_ros_control.so")
    (tmp_path / "r.urdf").write_text(whole_robot(robot))
    (tmp_path / "a.launch").write_text(
        '<launch><param name="robot_description" textfile="$(dirname)/r.urdf"/>'
        '<rosparam command="load" file="$(dirname)/c.yaml"/></launch>'
    )
    found = check(tmp_path / "a.launch", select=["RCT021"]).diagnostics
    assert len(found) == count
    for one in found:
        assert one.message == naming("drive", "swing", "effort")


WHEELS = "diff_drive_controller/DiffDriveController"


def test_state_interfaces_of_a_trajectory_controller(tmp_path: Path) -> None:
    text = controller("arm", joints="[swing, slide]", state_interfaces="[position, velocity]")
    first, second = state_reported(tmp_path, text)
    assert first.message == naming("arm", "swing", "velocity")
    assert (first.span.line, first.span.text) == (4, "swing")
    assert second.message == naming("arm", "velocity", "slide")


@pytest.mark.parametrize(
    ("feedback", "joint", "needs"),
    [
        ({}, "swing", "position"),
        ({"position_feedback": "false"}, "slide", "velocity"),
        ({"position_feedback": "True"}, "swing", "position"),
    ],
)
def test_wheels(tmp_path: Path, feedback: dict[str, str], joint: str, needs: str) -> None:
    (found,) = state_reported(
        tmp_path, controller("d", WHEELS, left_wheel_names=f"[{joint}]", **feedback)
    )
    assert f"{needs} of joint '{joint}'" in found.message


def test_a_gripper(tmp_path: Path) -> None:
    kind = "position_controllers/GripperActionController"
    (found,) = state_reported(tmp_path, controller("g", kind, joint="slide"))
    assert found.message == naming("g", "velocity", "slide")


FORWARD = "forward_command_controller/ForwardCommandController"
BROADCASTER = "joint_state_broadcaster/JointStateBroadcaster"


def test_a_broadcaster(tmp_path: Path) -> None:
    text = controller("b", BROADCASTER, joints="[slide]", interfaces="[position, effort]")
    (found,) = state_reported(tmp_path, text)
    assert found.message == naming("b", "effort", "slide")


@pytest.mark.parametrize(
    "text",
    [
        controller("b", BROADCASTER, interfaces="[effort]"),
        controller("b", BROADCASTER, joints="[slide]"),
        controller("d", WHEELS, left_wheel_names="[swing]", position_feedback="false"),
        controller("d", WHEELS, left_wheel_names="[swing]", open_loop="true"),
        controller("arm", joints="[slide]", state_interfaces="[position]"),
        controller("arm", joints="[slide]"),
        controller("arm", "acme/Own", joints="[slide]", state_interfaces="[effort]"),
        # marsupial_simulator_ros2: a forward controller does not read the parameter
        controller("f", FORWARD, joints="[slide]", state_interfaces="[effort]"),
        controller("arm", joints="[follow]", state_interfaces="[effort]"),
    ],
)
def test_states_that_are_offered_or_unknown(tmp_path: Path, text: str) -> None:
    assert state_reported(tmp_path, text) == []


MUTE = '<joint name="swing"><command_interface name="velocity"/></joint>'


@pytest.mark.parametrize(
    ("hardware", "interface", "severity"),
    [
        (GZ, "position_des", Severity.ERROR),
        ("acme/Motors", "effort", Severity.WARNING),
        ("acme/Motors", "velocty", Severity.WARNING),
        ("acme/Motors", "position_des", Severity.INFO),
    ],
)
def test_a_state_that_hardware_may_offer_unlisted(
    tmp_path: Path, hardware: str, interface: str, severity: Severity
) -> None:
    """legged_ros2: its hardware exports the commanded position as a state, too."""
    kind = "joint_state_broadcaster/JointStateBroadcaster"
    text = controller("states", kind, joints="[swing]", interfaces=f"[position, {interface}]")
    (found,) = reported(tmp_path, text, control(driven("swing"), plugin=hardware), "state")
    assert found.severity is severity


def test_a_joint_without_state() -> None:
    text = ROBOT + control(driven("slide"), MUTE)
    assert messages("RCT021", text) == [naming("swing", "interfaces")]
    assert places("RCT021", text) == [(NEXT + 3, '<joint name="swing">')]


def test_hardware_that_measures_nothing() -> None:
    """BlueROV2: the thrusters take the width of a pulse."""
    pulse = '<joint name="swing"><command_interface name="pwm"/></joint>'
    assert messages("RCT021", ROBOT + control(pulse)) == []


def test_the_state_may_be_in_another_block() -> None:
    sensor = '<joint name="swing"><state_interface name="position"/></joint>'
    text = ROBOT + control(MUTE) + control(sensor, name="s", kind="sensor")
    assert messages("RCT021", text) == []
    assert messages("RCT021", ROBOT + control('<joint name="swing"/>')) == []


def test_controllers_of_which_a_launch_file_starts_one(tmp_path: Path) -> None:
    """IC2D: one file for the variants with effort and with position interfaces."""
    effort, position = (
        controller(name, f"{name}_controllers/JointGroup{name.title()}Controller", joints="[slide]")
        for name in ("effort", "position")
    )
    assert len(reported(tmp_path, effort)) == 1
    assert reported(tmp_path, effort + position) == []


@pytest.mark.parametrize(("plugin", "severity"), [(GZ, Severity.ERROR), ("p/C", Severity.WARNING)])
def test_a_gripper_controller_of_the_mimicking_joint(
    tmp_path: Path, plugin: str, severity: Severity
) -> None:
    kind = "position_controllers/GripperActionController"
    block = control(driven("swing"), plugin=plugin)
    (found,) = reported_with_file("RCT021", tmp_path, controller("h", kind, joint="follow"), block)
    assert found.message == naming("h", "position", "follow", "<ros2_control>")
    assert (found.help, found.severity) == (naming("swing"), severity)
    other = controller("h", kind, joint="slide")
    assert reported_with_file("RCT021", tmp_path, other, block) == []
