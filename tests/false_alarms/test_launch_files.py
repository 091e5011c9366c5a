"""Launch files that are right: what the computer of the robot has is not in the repository."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

from tests.launched import launch, reported
from tests.workspaces import add_file, add_package


@pytest.mark.parametrize("mark", ["", ".git/HEAD"])
def test_absolute_paths_outside_of_the_repository(tmp_path: Path, mark: str) -> None:
    """Clearpath's robots keep their description in /etc/clearpath."""
    files = {mark: ""} if mark else {}
    text = '<rosparam file="/etc/clearpath/robot.yaml"/>'
    assert reported(tmp_path / "arm", "LAU003", "a.launch", text, files) == []
    program = (
        "import launch, launch_ros.actions\n"
        "def generate_launch_description():\n"
        "    return launch.LaunchDescription([launch_ros.actions.Node(package='p', "
        "executable='e', parameters=['/etc/clearpath/platform/config/control.yaml'])])\n"
    )
    assert reported(tmp_path / "arm", "LAU003", "a.launch.py", program, files) == []
    inside = f'<rosparam file="{tmp_path}/arm/config/robot.yaml"/>'
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", inside, files)) == 1


@pytest.mark.parametrize(("name", "count"), [(".urdf.xacro", 0), ("mine.yaml", 0), ("a.yaml", 1)])
def test_files_that_the_user_names_or_makes(tmp_path: Path, name: str, count: int) -> None:
    """Interbotix: $(arg robot_model).urdf.xacro, empty by default; Stretch: a calibration."""
    subprocess.run(["git", "init", "-q", tmp_path / "arm"], check=True)
    text = f'<rosparam file="$(dirname)/config/{name}"/>'
    files = {".gitignore": "mine.yaml\n"}
    assert len(reported(tmp_path / "arm", "LAU003", "a.launch", text, files)) == count


def test_what_roslaunch_does_not_read_uses_no_argument(tmp_path: Path) -> None:
    """MoveIt configurations of Robotnik: <param> in <include>, with arguments in a comment."""
    files = {"b.launch": "<launch/>"}
    text = '<include file="$(dirname)/b.launch"><param name="p" value="$(arg p)"/></include>'
    assert reported(tmp_path / "arm", "LAU006", "a.launch", text, files) == []
    passed = text.replace("param", "arg")
    assert len(reported(tmp_path / "arm", "LAU006", "a.launch", passed, files)) == 1


@pytest.mark.parametrize(
    ("default", "severity"), [("$(arg name)_base.xacro", "info"), ("fly_base.xacro", "warning")]
)
def test_a_launch_file_for_any_robot_passes_what_some_of_them_have(
    tmp_path: Path, default: str, severity: str
) -> None:
    """RotorS: spawn_mav.launch gives every model the same arguments."""
    text = (
        f'<arg name="name" default="fly"/><arg name="model" default="$(dirname)/../{default}"/>'
        '<param name="robot_description" command="xacro $(arg model) logging:=true"/>'
    )
    files = {"fly_base.xacro": '<robot name="fly"><link name="a"/></robot>'}
    (found,) = reported(tmp_path / "arm", "LAU005", "a.launch", text, files)
    assert (found.severity.value, found.help) == (severity, "remove the argument")


def test_arguments_that_make_an_expression(tmp_path: Path) -> None:
    """Unitree: `$(arg dollar)` before `(find go1_description)`, which roslaunch resolves later."""
    text = (
        '<arg name="dollar" value="$"/><arg name="path" default="(find go1_description)"/>'
        '<rosparam file="$(arg dollar)$(arg path)/config/control.yaml"/>'
    )
    assert reported(tmp_path / "arm", "LAU003", "a.launch", text) == []


@pytest.mark.parametrize(("package", "count"), [("arm", 0), ("other", 1)])
def test_arguments_from_a_launch_file_of_another_package(
    tmp_path: Path, package: str, count: int
) -> None:
    """Franka: `move_group.launch.py` gets all its arguments from a file of `franka_bringup`."""
    (tmp_path / ".git").mkdir()
    include = f'<include file="$(find {package})/launch/group.launch"/>'
    bringup = add_package(tmp_path / "bringup", "bringup")
    add_file(bringup / "launch" / "all.launch", launch(include).encode())
    text = '<node pkg="p" type="t" name="n" if="$(arg fake)"/>'
    assert len(reported(tmp_path / "arm", "LAU006", "group.launch", text)) == count


def test_the_cause_that_is_named_is_not_a_missing_package(tmp_path: Path) -> None:
    """ZED's examples: a package that the machine lacks, and a parameter that the macro lacks."""
    find = '<xacro:include filename="$(find lost)/a.xacro"/>'
    robot = f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{find}{{}}</robot>'
    text = '<param name="robot_description" command="xacro $(dirname)/../r.xacro"/>'
    files = {"r.xacro": robot.format('<xacro:property name="range" value="1"/>')}
    assert reported(tmp_path / "arm", "LAU004", "a.launch", text, files) == []
    files = {"r.xacro": robot.format('<link name="${1 +}"/>')}
    (found,) = reported(tmp_path / "arm", "LAU004", "a.launch", text, files)
    assert "'lost'" not in found.message
    assert found.message.endswith(", and 1 more")


@pytest.mark.parametrize(("inner", "count"), [("arm", 0), ("other", 1)])
def test_a_superbuild_around_the_package(tmp_path: Path, inner: str, count: int) -> None:
    """Husarion: `project(SUPERBUILD NONE)`, and the package in the other branch."""
    text = f"if(X)\n  project(SUPERBUILD NONE)\nelse()\n  project({inner})\nendif()\n"
    found = reported(tmp_path / "arm", "PKG005", "a.launch", "", {"CMakeLists.txt": text})
    assert len(found) == count
