"""Robots that lack arguments have those of the launch files of their package."""

import json
import shutil
from pathlib import Path

import pytest

from tests.conftest import CORPUS, needs_corpus
from tests.jointed import joint
from urdfkit import check
from urdfkit.cli import main
from urdfkit.lint.config_reader import load
from urdfkit.lint.fix import fix
from urdfkit.ros.launch.robot_arguments import passed_arguments
from urdfkit.workspace.resolve import Resolver

#: Its link has no name without an argument, and a mass that only one of the sizes is right for.
ARM = """\
<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="arm">
  <xacro:property name="size" value="$(arg size)"/>
  <link name="arm_${size}">
    <inertial><mass value="${2 if size == 'big' else -1}"/>
      <inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/></inertial>
  </link>
</robot>
"""
PYTHON = """\
def generate_launch_description():
    size = DeclareLaunchArgument("size", choices=["big", "small"])
    colour = DeclareLaunchArgument("colour", choices=["red", "blue"], default_value="red")
    command = Command(["xacro ", PathJoinSubstitution([FindPackageShare("arms"), "arm.xacro"]),
                       " size:=", LaunchConfiguration("size")])
    return LaunchDescription([size, colour, Node(package="p", parameters=[command])])
"""
XML = """\
<launch>
  <arg name="size"><choice value="big"/><choice value="small"/></arg>
  <node pkg="robot_state_publisher" exec="robot_state_publisher">
    <param name="robot_description"
      value="$(command 'xacro $(find-pkg-share arms)/arm.xacro size:=$(var size)')"/>
  </node>
</launch>
"""
COMMAND = """\
<launch>
  <arg name="size"/>
  <param name="robot_description"
    command="$(find xacro)/xacro $(find arms)/arm.xacro size:=$(arg size)"/>
</launch>
"""
INCLUDING = """\
<launch>
  <arg name="size" value="{}"/>
  <include file="$(find arms)/launch/arm.launch" pass_all_args="true"/>
</launch>
"""


@pytest.fixture
def package(tmp_path: Path) -> Path:
    (tmp_path / "package.xml").write_text("<package><name>arms</name></package>")
    (tmp_path / "arm.xacro").write_text(ARM)
    (tmp_path / "launch").mkdir()
    return tmp_path


@pytest.mark.parametrize(
    "files",
    [
        {"arm.launch.py": PYTHON},
        {"arm.launch.xml": XML},
        {
            "arm.launch": COMMAND,
            "big.launch": INCLUDING.format("big"),
            "small.launch": INCLUDING.format("small"),
        },
    ],
    ids=["Python", "ROS 2", "ROS 1"],
)
def test_every_choice_of_an_argument_is_checked(package: Path, files: dict[str, str]) -> None:
    for name, text in files.items():
        (package / "launch" / name).write_text(text)
    report = check(package)
    assert [one.arguments for one in report.launched] == [{"size": "big"}, {"size": "small"}]
    assert {Path(one.launch).name for one in report.launched} == set(files) - {"arm.launch"}
    assert [path for path in report.files if path.endswith("xacro")] == [str(package / "arm.xacro")]
    (found,) = (found for found in report.diagnostics if found.code == "INE001")
    assert found.span.line == 4
    assert "link 'arm_small'" in found.message
    assert found.calls[0].via[0].kind == "launch"


def test_an_unstarted_robot_gets_the_arguments_of_its_siblings(package: Path) -> None:
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    (package / "hand.xacro").write_text(ARM)
    found = passed_arguments(str(package / "hand.xacro"), ["size"], Resolver())
    assert [(one.arguments, one.frame) for one in found] == [
        ({"size": "big"}, None),
        ({"size": "small"}, None),
    ]


@pytest.mark.parametrize(
    ("text", "reason"),
    [
        (PYTHON.replace('"big", "small"', "*SIZES"), "choices that only running it tells"),
        (PYTHON.replace('choices=["big", "small"]', ""), "none"),
        ("def (", "no Python"),
    ],
)
def test_a_robot_without_a_required_argument_is_not_checked(
    package: Path, text: str, reason: str
) -> None:
    (package / "launch" / "arm.launch.py").write_text(text)
    report = check(package, ignore=["LAU", "XAC011"])
    assert report.launched == (), reason
    assert [found.code for found in report.diagnostics] == ["CFG003"]
    assert [skip.reason for skip in report.skipped] == ["it needs the argument 'size'"]


def test_a_named_robot_is_checked_like_its_directory(package: Path) -> None:
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    alone, whole = check(package / "arm.xacro"), check(package, ignore=["LAU", "XAC011"])
    assert alone.launched == whole.launched
    assert [one.message for one in alone.diagnostics] == [one.message for one in whole.diagnostics]
    (package / "launch" / "arm.launch.py").unlink()
    (found,) = check(package / "arm.xacro").diagnostics
    assert (found.code, found.help) == ("XAC010", "pass it: size:=VALUE")


def test_other_commands_report_the_used_arguments(
    package: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    assert main(["info", str(package / "arm.xacro")]) == 2
    said = capsys.readouterr().err
    assert "argument 'size' has no value and no default; pass it: size:=VALUE; " in said
    assert "arm.launch.py gives big, small" in said


def test_other_arguments_take_precedence(package: Path) -> None:
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    assert check(package, arguments={"size": "big"}).launched == ()
    (package / "urdfkit.toml").write_text(
        '[[robot]]\nfile = "arm.xacro"\narguments.size = "small"\n'
    )
    report = check(package, config=load(str(package / "urdfkit.toml")))
    assert report.launched == ()
    assert "INE001" in {found.code for found in report.diagnostics}


def test_reports_contain_the_arguments(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    assert main(["check", str(package)]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert f"({package / 'arm.xacro'} with size big, small of arm.launch.py)" in said
    assert main(["check", str(package), "--format", "json"]) == 1
    launched = json.loads(capsys.readouterr().out)["launched"]
    assert launched == [
        {
            "path": str(package / "arm.xacro"),
            "launch": str(package / "launch" / "arm.launch.py"),
            "arguments": {"size": size},
        }
        for size in ("big", "small")
    ]
    assert main(["init", str(package), "--print"]) == 0
    assert 'arguments.size = "big"  # or "small"\n' in capsys.readouterr().out


def test_long_arguments_are_counted(package: Path, capsys: pytest.CaptureFixture[str]) -> None:
    sizes = ", ".join(repr(letter * 100) for letter in "abc")
    text = PYTHON.replace('"big", "small"', sizes)
    (package / "launch" / "arm.launch.py").write_text(text)
    assert main(["check", str(package)]) == 1
    said = " ".join(capsys.readouterr().out.split())
    assert f"({package / 'arm.xacro'} with 3 values of size of arm.launch.py)" in said


def test_fixes_are_valid_for_every_choice(package: Path) -> None:
    """A fix that one way asks for, and another one that uses the place does not, is disputed."""
    (package / "launch" / "arm.launch.py").write_text(PYTHON)
    (package / "arm.xacro").write_text(
        ARM.replace("</robot>", '<link name="tip"/><joint name="j" type="fixed"/></robot>')
    )
    fixes = fix(package, unsafe=True)
    assert fixes.report.crashed == ()
    assert [one.arguments["size"] for one in fixes.report.launched] == ["big", "small"]


@needs_corpus
def test_every_arm_of_universal_robots_is_checked(tmp_path: Path) -> None:
    """Their xacro has a default on purpose that is none of them."""
    directory = tmp_path / "ur_description"
    shutil.copytree(CORPUS / "Universal_Robots_ROS2_Description", directory)
    (directory / "launch").mkdir()
    models = ["ur3", "ur5e", "ur10e"]
    text = PYTHON.replace("arms", "ur_description").replace("arm.xacro", "urdf/ur.urdf.xacro")
    text = text.replace('"size"', '"ur_type"').replace("size:=", "ur_type:=")
    (directory / "launch" / "view.launch.py").write_text(
        text.replace('"big", "small"', ", ".join(map(repr, models)))
    )
    report = check(directory, select=["URD", "JNT", "TRE", "XAC010"])
    started = {(Path(one.path).name, one.arguments["ur_type"]) for one in report.launched}
    assert started == {
        (name, model) for name in ("ur.urdf.xacro", "ur_mocked.urdf.xacro") for model in models
    }
    assert not any("needs arguments" in skip.reason for skip in report.skipped)


DEMO = """\
from moveit_configs_utils import MoveItConfigsBuilder
from moveit_configs_utils.launches import generate_{}_launch
def generate_launch_description():
    config = MoveItConfigsBuilder("arm", package_name="arm_moveit"){}.to_moveit_configs()
    return generate_{}_launch(config)
"""
CONTROLLERS = """\
controller_manager:
  ros__parameters:
    arm_controller:
      type: joint_trajectory_controller/JointTrajectoryController
arm_controller:
  ros__parameters:
    joints: [shoulder, elbwo]
    command_interfaces: [position]
    state_interfaces: [position]
"""


@pytest.mark.parametrize(
    ("launch", "method", "found"),
    [
        ("demo", "", 1),
        ("rsp", "", 0),  # starts no controller
        ("demo", '.robot_description(mappings={"size": "big"})', 0),
    ],
)
def test_the_controllers_of_a_moveit_demo(
    tmp_path: Path, launch: str, method: str, found: int
) -> None:
    (tmp_path / "package.xml").write_text("<package><name>arm_moveit</name></package>")
    for name in ("config", "launch"):
        (tmp_path / name).mkdir()
    joints = "".join(f'<joint name="{name}"/>' for name in ("shoulder", "elbow"))
    hardware = "<hardware><plugin>mock_components/GenericSystem</plugin></hardware>"
    text = f'<ros2_control name="c" type="system">{hardware}{joints}</ros2_control>'
    text += "".join(joint(name, "continuous") for name in ("shoulder", "elbow"))
    (tmp_path / "config/arm.urdf.xacro").write_text(
        f'<robot name="arm"><link name="base"/>{text}</robot>'
    )
    (tmp_path / "config/ros2_controllers.yaml").write_text(CONTROLLERS)
    (tmp_path / "launch/demo.launch.py").write_text(DEMO.format(launch, method, launch))
    report = check(tmp_path, select=["RCT001"])
    assert [one.span.text for one in report.diagnostics] == ["elbwo"] * found
