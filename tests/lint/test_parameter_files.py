"""Parameter files of Nav2 and slam_toolbox that no launch file loads."""

from pathlib import Path

import pytest

from tests.workspaces import add_file, add_package
from urdfkit import check
from urdfkit.errors import UnreadableFile
from urdfkit.lint.config import Config
from urdfkit.lint.options import Options
from urdfkit.lint.report import Report

NAV2 = "planner_server:\n  ros__parameters: {expected_planner_frequenzy: 20.0}\n"
MESSAGE = "'planner_server': unknown parameter 'expected_planner_frequenzy'; did you mean "
MESSAGE += "'expected_planner_frequency'?"
LAUNCH = """from launch_ros.actions import Node

def generate_launch_description():
    node = Node(package="nav2_planner", executable="planner_server", parameters=["../config/{}"])
"""
ROBOT = '<robot name="r"><link name="base_link"/></robot>'


@pytest.fixture
def package(tmp_path: Path) -> Path:
    (tmp_path / ".git").mkdir()
    return add_package(tmp_path / "nav", "nav")


def found(report: Report) -> list[tuple[str, str]]:
    """The findings about parameters, with their files."""
    assert report.crashed == ()
    return [
        (Path(one.span.source.path).name, one.message)
        for one in report.diagnostics
        if one.code.startswith("LAU")
    ]


def test_a_file_that_users_name_on_the_command_line(package: Path) -> None:
    file = add_file(package / "config" / "nav2.yaml", NAV2)
    add_file(package / "robot.urdf", ROBOT)
    for what in (package, file):
        assert found(check(what)) == [("nav2.yaml", MESSAGE)]


def test_a_package_of_parameters_alone(package: Path) -> None:
    add_file(package / "config" / "nav2.yaml", NAV2)
    report = check(package)
    assert found(report) == [("nav2.yaml", MESSAGE)]
    (unchecked,) = (one for one in report.diagnostics if one.code == "CFG003")
    assert unchecked.message.endswith("only 1 parameter file")
    add_file(package / "config" / "nav2.yaml", "planner_server: {expected: 1}\n")
    with pytest.raises(UnreadableFile, match=r"no \.urdf"):
        check(package)


@pytest.mark.parametrize(
    ("loaded", "expected"),
    [("nav2.yaml", ["nav2.yaml"]), ("other.yaml", []), ("none.yaml", ["nav2.yaml"])],
)
def test_a_file_is_checked_as_launch_files_load_it(
    package: Path, loaded: str, expected: list[str]
) -> None:
    """Once if one loads it; not at all beside one that is loaded: it may be an old one."""
    add_file(package / "launch" / "nav.launch.py", LAUNCH.format(loaded))
    add_file(package / "config" / "nav2.yaml", NAV2)
    add_file(package / "config" / "other.yaml", "planner_server:\n  ros__parameters: {}\n")
    messages = [message for _, message in found(check(package, select=["LAU024"]))]
    assert messages == [MESSAGE] * len(expected)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("drive.yaml", NAV2.replace("planner_server", "drive")),  # of another program
        ("nav2.yaml", NAV2.replace("ros__parameters", "parameters")),
        ("nav2.txt", NAV2),
        ("build/nav2.yaml", NAV2),
        ("old/nav2.yaml", NAV2),  # excluded
    ],
)
def test_other_files(package: Path, name: str, text: str) -> None:
    add_file(package / name, text)
    add_file(package / "robot.urdf", ROBOT)
    config = Config(path=str(package / "urdfkit.toml"), exclude=("old/*",))
    assert found(check(package, config=config)) == []


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ("planner_server:\n  ros__parameters: {a: [}\n", "LAU044"),
        ("ros__parameters: {a: 1}\n", "LAU044"),
        (b"planner_server:\n  ros__parameters: {a: \xff}\n", "LAU044"),
        ("ros__parameters: " + "[" * 50_000, "LAU044"),
        (NAV2 + "#" * 1024 * 1024, "CFG003"),
    ],
    ids=["not YAML", "without a node", "not UTF-8", "deep", "large"],
)
def test_a_file_that_cannot_be_read_is_not_green(
    package: Path, text: str | bytes, code: str
) -> None:
    report = check(add_file(package / "config" / "nav2.yaml", text))
    assert report.crashed == ()
    assert {one.code for one in report.diagnostics} == {code}


def test_frames_are_compared_with_the_robot_that_launch_files_start(package: Path) -> None:
    text = "planner_server:\n  ros__parameters: {}\nlocal_costmap:\n  local_costmap:\n"
    text += "    ros__parameters: {robot_base_frame: base_linc, global_frame: odom}\n"
    file = add_file(package / "config" / "nav2.yaml", text)
    add_file(package / "robot.urdf", ROBOT)
    add_file(
        package / "launch" / "robot.launch.xml",
        '<launch><node pkg="robot_state_publisher" exec="robot_state_publisher">'
        '<param name="robot_description" value="$(command \'xacro $(dirname)/../robot.urdf\')"/>'
        "</node></launch>",
    )
    ((_, message),) = found(check(file))
    assert "'base_linc'" in message
    assert "did you mean 'base_link'?" in message


def test_changed_files(package: Path) -> None:
    """A changed file is checked alone, or as the launch file that names it."""
    file = add_file(package / "config" / "nav2.yaml", NAV2)
    options = Options(changed=True)
    assert found(check(file, options=options)) == [("nav2.yaml", MESSAGE)]
    launch = add_file(package / "launch" / "nav.launch.py", LAUNCH.format("nav2.yaml"))
    report = check(file, options=options)
    assert ("nav2.yaml", MESSAGE) in found(report)
    assert report.files == (str(launch),)
    file.unlink()
    (missing,) = (one.code for one in check(file, options=options).diagnostics)
    assert missing == "LAU003"
