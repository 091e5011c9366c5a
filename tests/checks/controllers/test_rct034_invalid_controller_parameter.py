"""RCT034: see the rule."""

from pathlib import Path

import pytest

from tests.driving import DRIVE, place, reported, reported_in_ros_1
from tests.launched import MANIFEST, launch
from tests.naming import naming
from tests.workspaces import add_files, add_package
from urdfkit import Severity


@pytest.mark.parametrize(
    ("old", "new", "line", "text", "help"),
    [
        ("wheel_radius: 0.1", "wheel_radius: 1", 10, "1", "write 1.0"),
        ("wheel_radius: 0.1", "wheel_radius: 0,1", 10, "0,1", "write 0.1"),
        ("wheel_radius: 0.1", "wheel_radius: '0.1'", 10, "'0.1'", "write 0.1"),
        (
            "wheel_radius: 0.1",
            "wheel_radius: wide",
            10,
            "wide",
            naming("decimal point"),
        ),
        ("[left_joint]", "left_joint", 7, "left_joint", naming("list of strings")),
        ("frame_id: base", "frame_id: 1", 11, "1", "write a string"),
        ("ers:\n    drive", "ers:\n    update_rate: 9.0\n    drive", 3, "9.0", "write 9"),
    ],
)
def test_other_types_than_the_node_declares(
    tmp_path: Path, old: str, new: str, line: int, text: str, help: str
) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace(old, new))
    assert place(found) == ("c.yaml", line, text)
    assert found.help == help


@pytest.mark.parametrize(
    ("parameter", "message", "help"),
    [
        (
            "linear.x.min_velocity: 1.0",
            naming("drive", "linear.x.min_velocity", "1.0", "<= 0"),
            "change the sign",
        ),
        (
            "angular.z.max_acceleration: -2.0",
            naming("drive", "angular.z.max_acceleration", "-2.0", ">= 0"),
            "change the sign",
        ),
    ],
)
def test_values_of_a_drive(tmp_path: Path, parameter: str, message: str, help: str) -> None:
    (found,) = reported(tmp_path, "RCT034", f"{DRIVE}    {parameter}\n")
    assert (found.message, found.help) == (message, help)


def test_a_switch_that_later_releases_do_not_read(tmp_path: Path) -> None:
    """Humble has gz_ros2_control, too, so only what Jazzy added shows that it is not Humble."""
    drive = f"{DRIVE}    use_stamped_vel: false\n"
    (found,) = reported(tmp_path, "RCT034", drive)
    assert (found.severity, found.span.line) == (Severity.INFO, 12)
    assert found.help == naming("TwistStamped", "use_stamped_vel")
    (tmp_path / "package.xml").write_text(MANIFEST)
    (tmp_path / "mux.yaml").write_text("twist_mux:\n  ros__parameters:\n    use_stamped: true\n")
    mux = '<param from="$(find-pkg-share arm)/mux.yaml"/>'
    (tmp_path / "launch").mkdir()
    (tmp_path / "launch" / "mux.launch.xml").write_text(
        launch(f'<node pkg="twist_mux" exec="twist_mux">{mux}</node>')
    )
    (found,) = reported(tmp_path, "RCT034", drive)
    assert found.severity is Severity.WARNING


@pytest.mark.parametrize(
    "parameter",
    [
        "linear.x.min_velocity: -1.0",
        "linear.x.max_velocity: .nan",
        "use_stamped_vel: true",
        "linear.x.min_velocity: $(var slow)",
    ],
)
def test_valid_values_of_a_drive(tmp_path: Path, parameter: str) -> None:
    assert reported(tmp_path, "RCT034", f"{DRIVE}    {parameter}\n") == []


@pytest.mark.parametrize("rate", ["0", "-5"])
def test_rates_that_are_not_positive(tmp_path: Path, rate: str) -> None:
    text = DRIVE.replace("ers:\n    drive", f"ers:\n    update_rate: {rate}\n    drive")
    (found,) = reported(tmp_path, "RCT034", text)
    assert found.message == naming("update_rate", rate, "> 0")


@pytest.mark.parametrize(("given", "count"), [("updat_rate", 1), ("use_sim_time", 0)])
def test_a_misspelt_parameter_of_the_manager(tmp_path: Path, given: str, count: int) -> None:
    text = DRIVE.replace("ers:\n    drive", f"ers:\n    {given}: 9\n    drive")
    found = reported(tmp_path, "RCT034", text)
    assert [one.message for one in found] == [naming(given, "update_rate")] * count


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("wheel_radius: 0.1", "wheel_radius: $(var radius)"),  # filled in by launch
        ("wheel_radius: 0.1", "wheel_radius: 1e-1"),
        ("wheel_radius: 0.1", "wheel_radius:"),
        ("diff_drive_controller/Diff", "my_drive_controller/Diff"),
        ("frame_id: base", "frame_id: 'base'"),
    ],
)
def test_valid_parameters_are_accepted(tmp_path: Path, old: str, new: str) -> None:
    assert reported(tmp_path, "RCT034", DRIVE.replace(old, new)) == []


@pytest.mark.parametrize(
    ("old", "new", "line"),
    [
        ("wheel_separation", "wheel_seperation", 9),
        ("wheel_radius", "wheels_radius", 10),
        ("base_frame_id", "base_frame_idd", 11),
    ],
)
def test_a_misspelt_parameter(tmp_path: Path, old: str, new: str, line: int) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace(old, new))
    assert found.message == naming("drive", "unknown", new, old)
    assert place(found) == ("c.yaml", line, new)


def test_a_misspelt_type(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace("/DiffDriveC", "/DiffDirveC"))
    assert found.help == "write diff_drive_controller/DiffDriveController"
    assert found.span.line == 4


def test_a_type_that_its_package_does_not_export(tmp_path: Path) -> None:
    export = "pluginlib_export_plugin_description_file(controller_interface a.xml)\n"
    build = f"find_package(ament_cmake REQUIRED)\n{export}"
    description = '<library path="a"><class name="our_drive/Controller"/></library>'
    add_files(
        add_package(tmp_path / "our_drive", "our_drive"),
        {"CMakeLists.txt": build, "a.xml": description},
    )
    text = DRIVE.replace("diff_drive_controller/Diff", "our_drive/")
    (found,) = reported(tmp_path, "RCT034", text)
    assert (found.span.line, found.severity) == (4, Severity.WARNING)
    assert found.help.startswith("write our_drive/Controller")
    assert reported(tmp_path, "RCT034", text.replace("DriveController", "Controller")) == []


def test_unknown_names_that_are_not_typos(tmp_path: Path) -> None:
    more = DRIVE + "    linear.x.max_velocity: 1.0\n    angular:\n      z:\n        max_jerk: 1.0\n"
    assert reported(tmp_path, "RCT034", more + "    our_own: 1\n") == []
    assert reported(tmp_path, "RCT034", DRIVE.replace("diff_drive_controller/", "our_drive/")) == []


@pytest.mark.parametrize(
    "line", ["left_wheel_names: [left_joint]", "wheel_separation: 0.3", "wheel_radius: 0.1"]
)
def test_a_required_parameter_is_missing(tmp_path: Path, line: str) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace(f"    {line}\n", ""))
    assert place(found) == ("c.yaml", 5, "drive")
    assert found.message.endswith(f": {line.partition(':')[0]}")


def test_parameters_of_an_unknown_controller(tmp_path: Path) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace("\ndrive:", "\nbase_controller:"))
    assert place(found) == ("c.yaml", 5, "base_controller")
    assert found.help == naming("base_controller", "drive")


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("drive:\n  ros__parameters:\n    left", "other:\n  ros__parameters:\n    let"),
        ("diff_drive_controller/Diff", "my_drive_controller/Diff"),
    ],
)
def test_parameters_that_may_be_elsewhere_are_accepted(tmp_path: Path, old: str, new: str) -> None:
    assert reported(tmp_path, "RCT034", DRIVE.replace(old, new)) == []


def test_wheel_names_are_required_in_ros_1(tmp_path: Path) -> None:
    text = "drive:\n  type: diff_drive_controller/DiffDriveController\n  left_wheel: left_joint\n"
    (found,) = reported_in_ros_1(tmp_path, "RCT034", text)
    assert place(found) == ("c.yaml", 1, "drive")
    assert found.message.endswith(": right_wheel")


@pytest.mark.parametrize(
    ("joint", "help"),
    [
        ("joints: [left_joint, right_joint]", "use position_controllers/JointGroupPosition"),
        ("gains: {}", "add joint: ..."),
    ],
)
def test_several_joints_for_a_controller_of_one(tmp_path: Path, joint: str, help: str) -> None:
    """Arctos: `joints` for the controller of a single joint."""
    text = f"arm:\n  type: position_controllers/JointPositionController\n  {joint}\n"
    (found,) = reported_in_ros_1(tmp_path, "RCT034", text)
    assert found.message.endswith(": joint")
    assert found.help.startswith(help)


def test_a_joint_twice_in_ros_1(tmp_path: Path) -> None:
    text = "arm:\n  type: effort_controllers/JointTrajectoryController\n  joints: [{}]\n"
    assert reported_in_ros_1(tmp_path, "RCT034", text.format("left_joint, right_joint")) == []
    (found,) = reported_in_ros_1(tmp_path, "RCT034", text.format("left_joint, left_joint"))
    assert found.message == naming("arm", "left_joint", "twice")
    assert (place(found), found.severity) == (("c.yaml", 3, "left_joint"), Severity.WARNING)
    assert found.span.column == 24


CLASS = "diff_drive_controller/DiffDriveController"


@pytest.mark.parametrize(
    ("kind", "help"),
    [
        ("diff_drive_controller/Drive", naming(CLASS)),
        (
            "joint_state_controller/JointStateController",
            naming("joint_state_broadcaster/JointStateBroadcaster"),
        ),
    ],
)
def test_classes_that_ros_2_does_not_have(tmp_path: Path, kind: str, help: str) -> None:
    (found,) = reported(tmp_path, "RCT034", DRIVE.replace(CLASS, kind))
    assert place(found) == ("c.yaml", 4, kind)
    assert found.help == help


def test_a_class_of_ros_2_in_ros_1(tmp_path: Path) -> None:
    text = "states:\n  type: joint_state_broadcaster/JointStateBroadcaster\n"
    (found,) = reported_in_ros_1(tmp_path, "RCT034", text)
    assert place(found) == ("c.yaml", 2, "joint_state_broadcaster/JointStateBroadcaster")


@pytest.mark.parametrize("quantity", ["Effort", "Position"])
def test_groups_of_ros_1_that_command_forces(tmp_path: Path, quantity: str) -> None:
    text = f"""\
arm:
  type: effort_controllers/JointGroup{quantity}Controller
  joints: [left_joint]
"""
    assert reported_in_ros_1(tmp_path, "RCT034", text) == []


@pytest.mark.parametrize(
    "kind",
    [
        CLASS,
        "my_controllers/Drive",
    ],
)
def test_unknown_classes_are_accepted(tmp_path: Path, kind: str) -> None:
    assert reported(tmp_path, "RCT034", DRIVE.replace(CLASS, kind)) == []


TRAJECTORY = """\
controller_manager:
  ros__parameters:
    drive: {type: joint_trajectory_controller/JointTrajectoryController}
drive:
  ros__parameters:
    joints: [left_joint]
    command_interfaces: [velocity]
    state_interfaces: [position, velocity]
    gains: {left_joint: {p: 1.0}}
"""


def test_several_joints_for_a_gripper_of_one(tmp_path: Path) -> None:
    """ros2_moveit_manipulators: its class was named as the one for several joints."""
    old = "joint_trajectory_controller/JointTrajectoryController"
    text = TRAJECTORY.replace(old, "position_controllers/GripperActionController")
    (found,) = (one for one in reported(tmp_path, "RCT034", text) if "missing" in one.message)
    assert found.help == "write joint: NAME in place of joints, as it moves one joint"


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("[left_joint]", "[left_joint, left_joint]", "joints has 'left_joint' twice"),
        ("[position, velocity]", "[velocity]", "velocity without position"),
        ("    gains: {left_joint: {p: 1.0}}\n", "", "requires gains"),
    ],
)
def test_a_trajectory_controller(tmp_path: Path, old: str, new: str, message: str) -> None:
    assert reported(tmp_path, "RCT034", TRAJECTORY) == []
    (found,) = reported(tmp_path, "RCT034", TRAJECTORY.replace(old, new))
    assert message in found.message


def test_commands_without_feedback_need_no_gains(tmp_path: Path) -> None:
    text = TRAJECTORY.replace("gains: {left_joint: {p: 1.0}}", "open_loop_control: true")
    assert reported(tmp_path, "RCT034", text) == []


@pytest.mark.parametrize(
    ("kind", "parameters", "message"),
    [
        (
            "admittance_controller/AdmittanceController",
            "admittance: {mass: [1.0, 1.0, 1.0]}",
            "admittance.mass has 3 values, must have 6",
        ),
        (
            "admittance_controller/AdmittanceController",
            "kinematics: {plugin_package: kinematics_interface_kdl}",
            "kinematics.plugin_package has 'kinematics_interface_kdl'",
        ),
        (
            "ackermann_steering_controller/AckermannSteeringController",
            "traction_wheels_radius: 0.0",
            "traction_wheels_radius is 0.0, must be > 0",
        ),
        (
            "ackermann_steering_controller/AckermannSteeringController",
            "{wheelbase: 1.0, front_wheels_names: [left_joint], front_wheel_track: 1.0}",
            "required parameters are missing: traction_wheels_radius or rear_wheels_radius or f",
        ),
        (
            "pid_controller/PidController",
            "gains: {left_joint: {antiwindup_strategy: clamp}}",
            "gains.left_joint.antiwindup_strategy has 'clamp'",
        ),
    ],
)
def test_values_of_other_controllers(
    tmp_path: Path, kind: str, parameters: str, message: str
) -> None:
    head = DRIVE.partition("drive:\n  ros__")[0].replace("diff_drive_controller/DiffDriveC", "X")
    text = f"{head}drive:\n  ros__parameters:\n    {parameters}\n"
    text = text.replace("Xontroller", kind)
    found = [one.message for one in reported(tmp_path, "RCT034", text)]
    assert any(one.startswith(f"controller 'drive': {message}") for one in found)


CORNERS = [
    f"{end}_{side}_wheel_command_joint_name"
    for end in ("front", "rear")
    for side in ("left", "right")
]


@pytest.mark.parametrize(
    ("joints", "count"), [(("a", "b", "c", "d"), 0), (("a", "b", "c", "c"), 1), (("a", "a"), 1)]
)
def test_a_wheel_at_two_corners(tmp_path: Path, joints: tuple[str, ...], count: int) -> None:
    text = DRIVE.partition("drive:\n  ros__parameters:")[0].replace(
        "diff_drive_controller/DiffDriveController",
        "mecanum_drive_controller/MecanumDriveController",
    )
    rows = "".join(f"    {name}: {joint}\n" for name, joint in zip(CORNERS, joints, strict=False))
    found = reported(tmp_path, "RCT034", f"{text}drive:\n  ros__parameters:\n{rows}")
    names = [one.message for one in found if one.message.endswith(", too")]
    assert len(names) == count
    assert all(joints[-1] in name for name in names)
