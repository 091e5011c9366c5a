"""Messages that hid the defect: "has no <noise>" reads as if it were missing."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, block, sensor
from tests.launched import reported as of_launch
from tests.naming import naming
from tests.reported import reported
from tests.workspaces import add_file
from urdfkit import check
from urdfkit.core.suggest import nearest
from urdfkit.lint.rule_examples import whole_robot
from urdfkit.text.xml_errors import syntax_mistakes


def test_an_element_that_is_ignored_is_not_said_to_be_missing() -> None:
    noise = "<imu><noise><type>gaussian</type></noise></imu>\n"
    (found,) = reported("GAZ003", BASE + sensor("imu", noise))
    assert found.message == naming("s", "unknown", "<noise>", "<imu>", "ignored")
    assert "<angular_velocity>" in found.help


def test_suggestions_are_not_alike_for_their_last_word() -> None:
    """UR3's SRDF: `upper_arm_link` for `gripper_base_link`; Kinova's meshes."""
    assert nearest("gripper_base_link", ["upper_arm_link", "wrist_link"]) is None
    meshes = ["base_link", "bicep_link", "bracelet_no_vision_link"]
    assert nearest("bracelet_link", meshes) == "bracelet_no_vision_link"
    assert nearest("whel_link", ["base_link", "wheel_link"]) == "wheel_link"


def test_a_macro_that_is_closed_in_its_first_line() -> None:
    body = b'<link name="a"><visual/></link>' * 100
    data = b'<robot><macro name="m" params="x"/>' + body + b"</macro></robot>"
    (mistake,) = syntax_mistakes(data)
    assert [note for _, _, note in mistake.notes] == [
        "<macro .../> closes itself: its '/' is one too many"
    ]


def test_a_tag_with_tags_in_it_is_no_switch() -> None:
    """LIMO's noise of the orientation, which is no <enable_orientation>."""
    tag = "<orientation><x><noise/></x></orientation>"
    (found,) = reported("GAZ003", BASE + sensor("imu", f"<imu>{tag}</imu>"))
    assert "did you mean" not in found.message + found.help


@pytest.mark.parametrize(
    ("tag", "help"),
    [
        ("image_width", naming("<camera>", "<image>", "<width>")),
        ("near", naming("<camera>", "<clip>", "<near>")),
        ("vertical_fov", naming("<image>", "give")),
    ],
)
def test_a_tag_of_another_place_is_no_typo(tag: str, help: str) -> None:
    """description_omni_robot: "did you mean 'image'?"; w3_600b: horizontal_fov, which it has."""
    (found,) = reported("GAZ003", BASE + sensor("camera", f"<camera><{tag}>1</{tag}></camera>\n"))
    assert "did you mean" not in found.message
    assert found.help == help


@pytest.mark.parametrize(
    ("target", "severity"), [("classic-ros1", "warning"), ("gz-harmonic", "error")]
)
def test_sensors_of_a_file_that_is_included_twice(
    tmp_path: Path, target: str, severity: str
) -> None:
    """A robot whose sensors' file includes the plugins' file of the robot again."""
    head = '<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    add_file(tmp_path / "s.xacro", f"{head}{sensor('imu', '')}</robot>".encode())
    twice = '<xacro:include filename="s.xacro"/>' * 2
    robot = add_file(tmp_path / "r.xacro", f"{head}{BASE}{twice}</robot>".encode())
    (found,) = check(robot, select=["GAZ010"], targets=[target]).diagnostics
    assert (found.severity.value, found.help) == (severity, naming("once"))


@pytest.mark.parametrize(("target", "count"), [("classic-ros1", 0), ("gz-harmonic", 1)])
def test_a_material_of_a_script_in_the_workspace(tmp_path: Path, target: str, count: int) -> None:
    """Care-O-bot's worlds: `Media/materials/scripts/custom.material`."""
    text = whole_robot(BASE + block("<material>wall_floor</material>"))
    robot = add_file(tmp_path / "r.urdf", text.encode())
    assert len(check(robot, select=["GAZ007"], targets=[target]).diagnostics) == 1
    add_file(tmp_path / "Media" / "custom.material", b"material wall_floor\n{\n}\n")
    assert len(check(robot, select=["GAZ007"], targets=[target]).diagnostics) == count


def test_the_manager_that_an_included_file_starts(tmp_path: Path) -> None:
    """Another UR5: the one launch file simulates, and the other, for mock hardware, is included."""
    plugin = '<gazebo><plugin filename="gz_ros2_control-system" name="c"/></gazebo>'
    manager = "Node(package='controller_manager', executable='ros2_control_node')\n"
    spawner = "Node(package='ros_gz_sim', executable='create', arguments=['-topic', 't'])\n"
    robot = f"open('{tmp_path}/arm/r.urdf')\n"
    include = f"IncludeLaunchDescription('{tmp_path}/arm/launch/mock.launch.py')\n"
    files = {"r.urdf": f'<robot name="r"><link name="a"/>{plugin}</robot>'}
    assert of_launch(tmp_path / "arm", "LAU043", "mock.launch.py", robot + manager, files) == []
    text = spawner + include
    (found,) = of_launch(tmp_path / "arm", "LAU043", "simulated.launch.py", text)
    assert Path(found.span.source.path).name == "mock.launch.py"
    ((step,),) = (call.via for call in found.calls)
    assert Path(step.span.source.path).name == "simulated.launch.py"
    assert found.related[1].message == naming("spawned", "Gazebo")
