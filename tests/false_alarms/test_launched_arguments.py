"""Arguments of launch files that are right."""

from pathlib import Path

import pytest

from tests.launched import launch, reported
from tests.workspaces import add_file, add_package
from urdfkit.text.diagnostic import Severity


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


def test_an_argument_of_an_include_that_is_off(tmp_path: Path) -> None:
    """PickNik's UR5: `<arg unless="$(arg fake)" name="robot_ip"/>` for one of two files."""
    text = (
        '<arg name="fake" default="true"/><include file="$(dirname)/b.launch">'
        '<arg {}="$(arg fake)" name="robot_ip" value="10.0.0.1"/></include>'
    )
    files = {"launch/b.launch": "<launch/>"}
    assert reported(tmp_path / "arm", "LAU005", "a.launch", text.format("unless"), files) == []
    assert len(reported(tmp_path / "arm", "LAU005", "a.launch", text.format("if"), files)) == 1


@pytest.mark.parametrize(
    ("use", "severity"), [("", Severity.ERROR), ("controller_name", Severity.WARNING)]
)
def test_an_argument_that_resembles_one_that_is_used(
    tmp_path: Path, use: str, severity: Severity
) -> None:
    """Franka's example.launch.py requires `controller_names`; an included file has others."""
    text = (
        "from launch.actions import DeclareLaunchArgument\n"
        "from launch.substitutions import LaunchConfiguration\n"
        "DeclareLaunchArgument('controller_name', default_value='1')\n"
        "LaunchConfiguration('controller_nodes')\n"
    )
    text += f"LaunchConfiguration('{use}')\n" if use else ""
    (found,) = reported(tmp_path / "arm", "LAU006", "a.launch.py", text)
    assert found.severity is severity
    assert ("did you mean" in found.message) is (severity is Severity.ERROR)


@pytest.mark.parametrize(("more", "hint"), [("", True), ("fake_execution", False)])
def test_an_argument_that_is_passed_is_not_suggested(tmp_path: Path, more: str, hint: bool) -> None:
    """Robotnik's MoveIt packages: `execution_type` is not a misspelt `fake_execution`."""
    files = {"launch/b.launch": launch('<arg name="fake_execution" default="a"/>')}
    names = filter(None, ("execution", more))
    passed = "".join(f'<arg name="{name}" value="a"/>' for name in names)
    text = f'<include file="$(find arm)/launch/b.launch">{passed}</include>'
    (found,) = reported(tmp_path / "arm", "LAU005", "a.launch", text, files)
    assert ("mean 'fake_execution'?" in found.message) is hint
