"""Files and tags that belong to other programs than ROS's."""

from pathlib import Path

import pytest

from tests.launched import reported as of_launch
from tests.workspaces import add_file, add_package, mesh_link
from urdfkit import check
from urdfkit.ros.controllers import read
from urdfkit.text.source import Source

SCRIPT = "#! /usr/bin/env python3\nimport launch\n"
ECLIPSE = '<launchConfiguration type="debug"/>\n'
READER = 'tag = ET.parse(path).find("thrust_rate")  # ElementTree\n'


@pytest.mark.parametrize(
    ("text", "severity"), [(SCRIPT, "info"), (ECLIPSE, "info"), ("<robot/>", "error")]
)
def test_a_file_that_only_has_the_suffix_of_a_launch_file(
    tmp_path: Path, text: str, severity: str
) -> None:
    """Navigation 2's tests, and a project of STM32CubeIDE in jsk_aerial_robot."""
    add_package(tmp_path / "arm", "arm")
    (found,) = check(
        add_file(tmp_path / "arm/launch/test.launch", text.encode()), select=["LAU"]
    ).diagnostics
    assert (found.code, found.severity.value) == ("LAU001", severity)


@pytest.mark.parametrize(
    ("text", "severity"),
    [
        ("/mentor/supervisor:\n  ros__parameters:\n    motor: JGB37\n", "info"),
        ("lanch:\n- node: {pkg: p, exec: e}\n", "error"),
    ],
)
def test_a_parameter_file_named_like_a_launch_file(
    tmp_path: Path, text: str, severity: str
) -> None:
    """Mentor Pi: the parameters of a test are in `configuration_supervisor_launch.yaml`."""
    add_package(tmp_path / "arm", "arm")
    path = add_file(tmp_path / "arm/test/supervisor_launch.yaml", text.encode())
    (found,) = check(path, select=["LAU"]).diagnostics
    assert (found.code, found.severity.value) == ("LAU001", severity)


@pytest.mark.parametrize(
    ("name", "text", "severity"),
    [
        ("tmuxp/base_launch.yaml", "session_name: base\nwindows: []\n", "info"),
        ("launch/base_launch.yaml", "session_name: base\nwindows: []\n", "error"),
        ("tmuxp/base_launch.yaml", "name: base\nlanch: []\n", "error"),
        ("tmuxp/base_launch.yaml", "arg: {name: a}\nnode: {pkg: p, exec: e}\n", "error"),
    ],
)
def test_the_configuration_of_another_program(
    tmp_path: Path, name: str, text: str, severity: str
) -> None:
    """marsrover_4.0: tmuxp starts the terminals of a mission by base_launch.yaml."""
    (found,) = check(add_file(tmp_path / name, text.encode()), select=["LAU001"]).diagnostics
    assert found.severity.value == severity


def test_an_argument_that_callers_must_pass(tmp_path: Path) -> None:
    """cartographer_ros: its users pass bag_filename, which no file declares."""
    text = '<arg name="urdf_filename" default=""/><node pkg="p" type="t" name="{}" args="{}"/>'
    bag, typo = (text.format(name, f"$(arg {name})") for name in ("pose_graph", "urdf_filenme"))
    (found,) = of_launch(tmp_path / "arm", "LAU006", "a.launch", bag)
    assert found.severity.value == "info"
    assert "did you mean" not in found.message
    (found,) = of_launch(tmp_path / "arm", "LAU006", "a.launch", typo)
    assert found.severity.value == "error"


def test_a_record_of_which_a_program_makes_a_controller() -> None:
    """jsk_aerial_robot's servo bridge adds the joint, whose name stands beside."""
    settings = "{pid: {p: 5.0}, type: effort_controllers/JointPositionController}"
    text = f"servo:\n  controller1:\n    name: gimbal1\n    simulation: {settings}\n"
    assert read(Source("servo.yaml", text.encode())) == ()
    space = text.replace("name: gimbal1", "rate: 50").encode()
    assert [one.name for one in read(Source("servo.yaml", space))] == ["simulation"]


@pytest.mark.parametrize(
    ("name", "text", "severity"),
    [
        ("arm/scripts/model.py", READER, "info"),
        ("arm/scripts/model.py", READER.replace("ElementTree", ""), "warning"),
        ("arm/scripts/model.py", READER.replace("thrust_rate", "thrust"), "warning"),
        ("arm/model.txt", READER, "warning"),
    ],
)
def test_a_tag_that_a_program_of_the_workspace_reads(
    tmp_path: Path, name: str, text: str, severity: str
) -> None:
    """jsk_aerial_robot's <m_f_rate>."""
    add_package(tmp_path / "arm", "arm")
    add_file(tmp_path / name, text.encode())
    robot = '<robot name="r"><link name="a"/><thrust_rate value="0"/></robot>'
    path = add_file(tmp_path / "arm/r.urdf", robot.encode())
    (found,) = check(path, select=["URD001"]).diagnostics
    assert found.severity.value == severity
    assert (found.fix is None) is (severity == "info")


@pytest.mark.parametrize(
    ("program", "depends", "severity"),
    [
        ("robots/driver", "", "info"),  # next to it
        ("model", "<depend>model</depend>", "info"),
        ("model", "", "warning"),
        ("elsewhere/model", "<depend>model</depend>", "warning"),
    ],
)
def test_the_packages_whose_programs_are_searched(
    tmp_path: Path, program: str, depends: str, severity: str
) -> None:
    (tmp_path / ".git").mkdir()
    arm = add_package(tmp_path / "robots/arm", "arm")
    manifest = arm / "package.xml"
    text = manifest.read_text(encoding="utf-8")
    manifest.write_text(text.replace("</package>", f"{depends}</package>"), encoding="utf-8")
    add_package(tmp_path / program, "model")
    add_file(tmp_path / program / "src/model.py", READER.encode())
    robot = '<robot name="r"><link name="a"/><thrust_rate value="0"/></robot>'
    path = add_file(arm / "r.urdf", robot.encode())
    (found,) = check(path, select=["URD001"]).diagnostics
    assert found.severity.value == severity


def test_a_list_of_joints_is_no_robot(tmp_path: Path) -> None:
    """bluerov_ros_playground: the range of each thruster, for the node that drives them."""
    joints = "".join(
        f'<joint name="thr{n}"><limit lower="-40" upper="49"/></joint>' for n in (1, 2)
    )
    path = add_file(tmp_path / "thrusters.urdf", f'<robot name="t">{joints}</robot>'.encode())
    (found,) = check(path, select=["TRE", "URD", "JNT", "REF"]).diagnostics
    assert (found.code, found.severity.value) == ("TRE001", "info")


def test_sensors_of_mujoco(tmp_path: Path) -> None:
    """mujoco_ros2_control: <sensor> in <mujoco> is not Gazebo's."""
    sensor = '<mujoco><sensor><force name="f" site="s"/></sensor></mujoco>'
    text = f'<robot name="r"><link name="a"/>{sensor}</robot>'
    assert not check(add_file(tmp_path / "r.urdf", text.encode()), select=["URD008"]).diagnostics


@pytest.mark.parametrize("target", [None, "ros1", "gz-harmonic"])
@pytest.mark.parametrize("head", [b"#VRML V2.0 utf8\n", b"#Inventor V2.1 ascii\n"])
def test_scene_files_of_planners(tmp_path: Path, head: bytes, target: str | None) -> None:
    """Kautham's robots, in a package of ROS 1: it reads them as Open Inventor does."""
    add_file(tmp_path / "can.wrl", head)
    robot = add_file(
        tmp_path / "can.urdf", f"<robot name='r'>{mesh_link('can.wrl')}</robot>".encode()
    )
    report = check(robot, select=["MSH"], targets=[target] if target else [])
    assert {(one.code, one.severity.value) for one in report.diagnostics} == {
        ("MSH007", "error" if target == "gz-harmonic" else "warning")
    }
