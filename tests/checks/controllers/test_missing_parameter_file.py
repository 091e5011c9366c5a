from pathlib import Path

import pytest

from tests.controls import NEXT, ROBOT, plugin
from tests.naming import naming
from tests.reported import messages, places, reported
from tests.xacros import xacro
from urdfkit import check
from urdfkit.text.diagnostic import Severity


def robot(path: str) -> str:
    return ROBOT + plugin("gz_ros2_control-system", f"<parameters>{path}</parameters>")


def test_missing_file() -> None:
    assert messages("RCT026", robot("/no/such/directory/c.yaml")) == [
        naming("machine", "/no/such/directory/c.yaml")
    ]
    assert places("RCT026", robot("/no/such/directory/c.yaml")) == [(NEXT, "<parameters>")]


@pytest.mark.parametrize(
    "directory", ["/tmp", "/home/me/arm/config/temp", "/home/me/arm/generated"]
)
def test_generated_file_is_accepted(directory: str) -> None:
    assert reported("RCT026", robot(f"{directory}/controllers.yaml")) == []
    assert len(reported("RCT026", robot(f"{directory}/config/controllers.yaml"))) == 1


def test_path_on_another_machine(tmp_path: Path) -> None:
    (tmp_path / ".git").mkdir()
    for path, severity in (
        ("/workspace/install/arm/share/arm/config/c.yaml", Severity.WARNING),
        (f"{tmp_path}/config/c.yaml", Severity.ERROR),
    ):
        (found,) = reported("RCT026", robot(path), str(tmp_path / "robot.urdf"))
        assert found.severity is severity


def test_suggested_file_next_to_it(tmp_path: Path) -> None:
    (tmp_path / "controllers.yaml").write_text("")
    (message,) = messages("RCT026", robot(f"{tmp_path}/controler.yaml"))
    assert message == naming(f"{tmp_path}/controler.yaml", "controllers.yaml")
    assert reported("RCT026", robot(f"{tmp_path}/controllers.yaml")) == []


def test_paths_that_are_not_checked() -> None:
    for path in ("c.yaml", "$(find p)/c.yaml", ""):
        assert reported("RCT026", robot(path)) == []
    other = plugin("libgazebo_ros_camera.so", "<parameters>/no/such.yaml</parameters>")
    assert reported("RCT026", ROBOT + other) == []


def test_a_path_of_a_package(tmp_path: Path) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    (tmp_path / "config").mkdir()
    (tmp_path / "config" / "c.yaml").write_text("")
    file = tmp_path / "r.xacro"
    text = robot("$(find p)/config/c.yaml")
    file.write_text(f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{text}</robot>')
    assert check(file, select=["RCT026"]).diagnostics == ()
    (tmp_path / "config" / "c.yaml").unlink()
    (found,) = check(file, select=["RCT026"]).diagnostics
    assert found.message == naming(f"{tmp_path}/config/c.yaml")


@pytest.mark.parametrize("above", ["/home/me/ws/src/arm", "/opt/ws/install/arm/share/arm"])
def test_a_path_of_another_computer_means_a_file_of_this_workspace(
    tmp_path: Path, above: str
) -> None:
    """It is reported, and its controllers are checked all the same."""
    (tmp_path / "package.xml").write_text("<package><name>arm</name></package>")
    (tmp_path / "config").mkdir()
    built = tmp_path / "install" / "arm" / "share" / "arm" / "config"  # in git by mistake
    built.mkdir(parents=True)
    (built / "c.yaml").touch()
    (tmp_path / "config" / "c.yaml").write_text(
        "controller_manager:\n  ros__parameters:\n    c: {type: a/B}\nc:\n  ros_parameters: {}\n"
    )
    file = tmp_path / "robot.urdf"
    file.write_text(f'<robot name="r">{robot(f"{above}/config/c.yaml")}</robot>')
    misspelt, missing = check(file, select=["RCT026"]).diagnostics
    assert missing.message == naming(f"{above}/config/c.yaml")
    assert "$(find arm)/config/c.yaml" in missing.help
    assert misspelt.message == naming("c", "ros_parameters", "ros__parameters")


@pytest.mark.parametrize(
    ("arguments", "severity"),
    [({}, Severity.INFO), ({"file": "{}/gone.yaml"}, Severity.ERROR)],
)
def test_a_path_that_is_passed(
    tmp_path: Path, arguments: dict[str, str], severity: Severity
) -> None:
    """A default may be a placeholder; what a launch file or the user passes is meant."""
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    file = tmp_path / "r.xacro"
    argument = f'<xacro:arg name="file" default="{tmp_path}/none.yaml"/>'
    text = argument + robot("$(arg file)")
    file.write_text(f'<robot name="r" xmlns:xacro="http://www.ros.org/wiki/xacro">{text}</robot>')
    passed = {name: value.format(tmp_path) for name, value in arguments.items()}
    (found,) = check(file, select=["RCT026"], arguments=passed).diagnostics
    assert found.severity is severity


@pytest.mark.parametrize(
    ("given", "severity"),
    [("", Severity.WARNING), ("file:=$(find-pkg-share p)/config/other.yaml", Severity.ERROR)],
)
def test_the_default_with_which_a_launch_file_starts_the_robot(
    tmp_path: Path, given: str, severity: Severity
) -> None:
    (tmp_path / "package.xml").write_text("<package><name>p</name></package>")
    argument = '<xacro:arg name="file" default="$(find p)/config/no.yaml"/>'
    (tmp_path / "r.xacro").write_text(xacro(argument + robot("$(arg file)")))
    (tmp_path / "launch").mkdir()
    command = f"'xacro $(find-pkg-share p)/r.xacro {given}'"
    (tmp_path / "launch" / "a.launch.xml").write_text(
        '<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">'
        f'<param name="robot_description" value="$(command {command})" type="str"/></node></launch>'
    )
    report = check(tmp_path / "launch" / "a.launch.xml", select=["RCT026"])
    assert [one.severity for one in report.diagnostics] == [severity]
