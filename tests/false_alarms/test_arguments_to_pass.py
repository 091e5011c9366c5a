"""Arguments of a xacro that have no value unless they are passed."""

from pathlib import Path

import pytest

from tests.gazebos import BASE, plugin
from tests.launched import MANIFEST, launch, reported
from tests.naming import naming
from tests.workspaces import add_file
from urdfkit import Source, check

XACRO = '<robot name="$(arg model)" xmlns:xacro="http://www.ros.org/wiki/xacro">\n{}</robot>\n'
DESCRIPTION = '<param name="robot_description" command="xacro $(dirname)/../r.xacro {}:=true"/>'


@pytest.mark.parametrize(
    "use",
    [
        '<xacro:if value="$(arg DEBUG)"><link name="world"/></xacro:if>',
        "<link name=\"${xacro.arg('DEBUG')}\"/>",
    ],
)
def test_an_argument_that_is_used_and_not_declared(tmp_path: Path, use: str) -> None:
    """Unitree's `DEBUG`, which every launch file passes; AR4's `name="$(arg ar_model)"`."""
    robot = XACRO.replace("$(arg model)", "r").format(use)
    for argument, count in (("DEBUG", 0), ("DEBUGS", 1)):
        text = DESCRIPTION.format(f"DEBUG:=true {argument}")
        found = reported(tmp_path / argument, "LAU005", "a.launch", text, {"r.xacro": robot})
        assert [one.help for one in found] == [naming("DEBUG")] * count


@pytest.mark.parametrize(("value", "count"), [("$(arg file)", 0), ("${file}", 1), (" ", 1)])
def test_a_parameter_that_the_launch_file_passes(tmp_path: Path, value: str, count: int) -> None:
    """AR4 and Universal Robots: `simulation_controllers`, empty by default."""
    given = '<xacro:arg name="file" default=""/><xacro:property name="file" value=""/>'
    tags = plugin("gz_ros2_control-system", f"<parameters>{value}</parameters>")
    robot = XACRO.replace("$(arg model)", "r").format(given + BASE + tags)
    add_file(tmp_path / "r.urdf.xacro", robot.encode())
    report = check(tmp_path / "r.urdf.xacro", select=["GAZ017"], targets=["gz-harmonic"])
    assert len(report.diagnostics) == count


EARLY = XACRO.format('<xacro:arg name="model" default="r"/>' + BASE)

PUBLISHED = """\
import os
from arm.descriptions import expanded
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import Command, LaunchConfiguration, ThisLaunchFileDir
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        {}
        Node(package='robot_state_publisher', executable='robot_state_publisher',
             parameters=[{{'robot_description': {}}}])])
"""


def launched(directory: Path, robot: str, text: str, code: str) -> list[str]:
    """The codes of a package with a robot and a launch file in Python."""
    add_file(directory / "package.xml", MANIFEST.encode())
    add_file(directory / "r.xacro", robot.encode())
    add_file(directory / "launch" / "a.launch.py", text.encode())
    return [one.code for one in check(directory, select=[code]).diagnostics]


def published(description: str, *arguments: str) -> str:
    """A launch file that publishes a description, with arguments."""
    declared = [f"DeclareLaunchArgument({argument})," for argument in arguments]
    return PUBLISHED.format(" ".join(declared), description)


@pytest.mark.parametrize(("passed", "count"), [("model", 0), ("other", 1)])
def test_an_argument_above_its_default_that_launch_files_pass(
    tmp_path: Path, passed: str, count: int
) -> None:
    """Universal Robots' `ur_gz.urdf.xacro`: `name:=ur`; RB1's `prefix`, for any of its robots."""
    text = DESCRIPTION.format(passed)
    (tmp_path / "package.xml").write_text(MANIFEST)
    add_file(tmp_path / "r.xacro", EARLY.encode())
    add_file(tmp_path / "launch" / "a.launch", launch(text).encode())
    for given in (tmp_path, tmp_path / "r.xacro"):
        assert len(check(given, select=["XAC020"]).diagnostics) == count


@pytest.mark.parametrize(
    ("own", "base", "count"),
    [("model", "", 0), ("other", "", 1), ("other", "model", 0), ("other", "others", 1)],
)
def test_an_argument_above_its_default_that_moveit_pro_passes(
    tmp_path: Path, own: str, base: str, count: int
) -> None:
    """moveit_pro_example_ws: `name` is one of the `urdf_params`, also in the package below."""
    add_file(tmp_path / "arm" / "package.xml", MANIFEST.encode())
    add_file(tmp_path / "base" / "package.xml", MANIFEST.replace("arm", "base").encode())
    add_file(tmp_path / "arm" / "description" / "r.xacro", EARLY.encode())
    robot = "hardware:\n  robot_description:\n    urdf:\n      path: description/{}.xacro\n"
    text = robot + "    urdf_params:\n      - {}: r\n"
    extended = 'based_on_package: "base"\n' if base else ""
    add_file(
        tmp_path / "arm" / "config" / "config.yaml", (extended + text.format("r", own)).encode()
    )
    add_file(tmp_path / "base" / "config" / "config.yaml", text.format("small", base).encode())
    assert len(check(tmp_path, select=["XAC020"]).diagnostics) == count
    add_file(tmp_path / "arm" / "config" / "config.yaml", text.format("s", own).encode())
    assert len(check(tmp_path, select=["XAC020"]).diagnostics) == 1  # of another robot


@pytest.mark.parametrize(("mappings", "count"), [("{'model': model}", 0), ("{'other': 'r'}", 1)])
def test_an_argument_above_its_default_that_is_known_at_run_time(
    tmp_path: Path, mappings: str, count: int
) -> None:
    """franka_arm.gazebo.xacro: a function of the launch file gets `robot_type` from the context."""
    text = f"""\
import os, xacro
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, OpaqueFunction
from launch.substitutions import LaunchConfiguration

def start(context):
    model = context.perform_substitution(LaunchConfiguration('model'))
    path = os.path.join(get_package_share_directory('arm'), 'r.xacro')
    description = xacro.process_file(path, mappings={mappings}).toxml()
    return []

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('model'), OpaqueFunction(function=start)])
"""
    assert launched(tmp_path, EARLY, text, "XAC020") == ["XAC020"] * count


@pytest.mark.parametrize("part", ["", '<xacro:include filename="$(find missing)/arm.xacro"/>'])
@pytest.mark.parametrize(("passed", "count"), [("model", 0), ("other", 1)])
def test_an_argument_above_its_default_in_a_command_that_is_not_all_known(
    tmp_path: Path, passed: str, count: int, part: str
) -> None:
    """Universal Robots' `ur_rsp.launch.py`: `robot_ip` has no default, `name` is the model."""
    text = published(
        "Command(['xacro ', ThisLaunchFileDir(), '/../r.xacro robot_ip:=', "
        f"LaunchConfiguration('robot_ip'), ' {passed}:=', LaunchConfiguration('model')])",
        "'robot_ip'",
        "'model', choices=['small', 'large']",
    )
    found = launched(tmp_path, EARLY.replace(BASE, part + BASE), text, "XAC020")
    assert found.count("XAC020") == count


@pytest.mark.parametrize(
    ("name", "passed", "count"), [("r", "model", 0), ("r", "other", 1), ("dual_r", "model", 1)]
)
def test_an_argument_above_its_default_that_a_function_takes(
    tmp_path: Path, name: str, passed: str, count: int
) -> None:
    """xArm's `xarm_device.urdf.xacro`: a function of another file calls xacro, with `dof`."""
    path = f"os.path.join(os.path.dirname(__file__), '..', '{name}.xacro')"
    arguments = f"arguments={{'{passed}': LaunchConfiguration('model')}}"
    text = published(f"expanded({path}, {arguments})", "'model', default_value='small'")
    assert launched(tmp_path, EARLY, text, "XAC020") == ["XAC020"] * count


SIZED = XACRO.replace("$(arg model)", "r").format(
    '<xacro:arg name="dof" default="7"/>'
    '<xacro:include filename="$(arg arm)_$(arg dof).xacro"/>' + BASE
)


@pytest.mark.parametrize("arm", ['<xacro:arg name="arm" default="gen3"/>', ""])
@pytest.mark.parametrize(("default", "codes"), [("", []), (", default_value='7'", ["XAC001"])])
def test_a_choice_that_does_not_expand_with_another_default(
    tmp_path: Path, default: str, codes: list[str], arm: str
) -> None:
    """Kinova's `kortex_control.launch.py`: `gen3_lite` has six joints; `dof` has no default."""
    add_file(tmp_path / "gen3_7.xacro", b'<robot name="part"/>')
    text = published(
        "Command(['xacro ', ThisLaunchFileDir(), '/../r.xacro arm:=', "
        "LaunchConfiguration('arm'), ' dof:=', LaunchConfiguration('dof')])",
        "'arm', choices=['gen3', 'gen3_lite']",
        f"'dof'{default}",
    )
    found = launched(tmp_path, SIZED.replace("<xacro:arg", f"{arm}<xacro:arg", 1), text, "XAC001")
    assert [code for code in found if code != "CFG003"] == codes


DUAL = XACRO.replace("$(arg model)", "r").format(
    '<xacro:arg name="sim" default=""/>' + BASE + '<xacro:if value="$(arg sim)"/>'
)


@pytest.mark.parametrize(("argument", "codes"), [("sim", []), ("slim", ["XAC001"])])
def test_defaults_that_do_not_suffice(tmp_path: Path, argument: str, codes: list[str]) -> None:
    """Kinova's `kortex_dual_robots.xacro`: empty defaults, and a launch file that gives all."""
    (tmp_path / "package.xml").write_text(MANIFEST)
    add_file(tmp_path / "r.xacro", DUAL.encode())
    add_file(tmp_path / "launch" / "a.launch", launch(DESCRIPTION.format(argument)).encode())
    assert [one.code for one in check(tmp_path, select=["XAC001"]).diagnostics] == codes


def test_a_urdf_that_a_launch_file_gives_to_xacro() -> None:
    """Self-Balancing-Robot: `sbr.urdf` has `$(find sbr_pjt)` and no namespace of xacro."""
    link = '<robot name="r"><link name="{}"/></robot>'
    for name, severity in (("$(arg side)_arm", "warning"), ("${side}_arm", "error")):
        report = check(Source("r.urdf", link.format(name).encode()), select=["XAC003"])
        assert [one.severity.value for one in report.diagnostics] == [severity]


@pytest.mark.parametrize(
    ("default", "code"), [("None", "XAC010"), ("", "XAC010"), ("arm", "XAC001")]
)
def test_a_default_that_names_no_file(tmp_path: Path, default: str, code: str) -> None:
    """Aubo: the launch file of another repository passes the type of the arm."""
    arguments = (
        f'<xacro:arg name="ip" default="{default}"/><xacro:arg name="model" default="{default}"/>'
    )
    include = '<xacro:property name="model" value="$(arg model)"/>\n'
    include += '<xacro:include filename="${model}.urdf.xacro"/>'
    robot = add_file(tmp_path / "r.xacro", XACRO.format(arguments + include).encode())
    (found,) = check(robot, select=["XAC001", "XAC010"]).diagnostics
    assert found.code == code
    assert ("'model'" in found.message) is (code == "XAC010")


@pytest.mark.parametrize(
    ("default", "name", "code"),
    [
        ("", "base$(arg drive).xacro", "XAC010"),
        ("", "base${drive}.xacro", "XAC010"),
        ("2WD", "base$(arg drive).xacro", "XAC001"),
        ("", "bases$(arg drive).xacro", "XAC001"),
        ("", "base.xacro", "XAC001"),
    ],
)
def test_an_empty_part_of_the_name_of_a_file(
    tmp_path: Path, default: str, name: str, code: str
) -> None:
    """Romea: the program that tests the hardware passes the kind of the drive."""
    content = f'<xacro:arg name="drive" default="{default}"/>'
    content += (
        f'<xacro:property name="drive" value="$(arg drive)"/><xacro:include filename="{name}"/>'
    )
    add_file(tmp_path / "base4WD.xacro", XACRO.format("").encode())
    robot = add_file(
        tmp_path / "r.xacro", XACRO.replace("$(arg model)", "r").format(content).encode()
    )
    (found,) = check(robot, select=["XAC001", "XAC010"]).diagnostics
    assert found.code == code


def test_a_default_with_which_a_file_does_not_exist(tmp_path: Path) -> None:
    """Stretch 4: the argument has a default, and its own name is no other one."""
    content = '<xacro:arg name="batch" default="none"/>'
    content += '<xacro:property name="kind" value="$(arg batch)"/><link name="a"/>'
    content += '<xacro:include filename="${kind}.xacro"/>'
    add_file(tmp_path / "r.xacro", XACRO.format(content).encode())
    found = [one for one in check(tmp_path).diagnostics if one.code == "CFG003"]
    assert [one.message.count("batch") for one in found] == [1]
