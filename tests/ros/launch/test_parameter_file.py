"""Parameter files that no launch file loads, and those that launch files of Nav2 get."""

from pathlib import Path

import pytest

from tests.workspaces import add_file
from urdfkit.ros.launch import read_launch
from urdfkit.ros.launch.contents import PARAMETERS
from urdfkit.text.source import Source
from urdfkit.workspace.resolve import Resolver

PARAMETERS_OF_ROBOT = """bot/amcl:
  ros__parameters: {}
planner_server:
  ros__parameters: {}
drive:
  ros__parameters: {}
"""
INCLUDE = """IncludeLaunchDescription(
    os.path.join(get_package_share_directory("nav2_bringup"), "launch", "bringup_launch.py"),
    launch_arguments={{"params_file": "/nav2.yaml", {}}}.items())
"""
AMCL = "nav2_amcl/amcl"


def test_the_programs_of_its_sections(tmp_path: Path) -> None:
    path = add_file(tmp_path / "nav2.yaml", PARAMETERS_OF_ROBOT)
    launch = read_launch(Source.read(path), Resolver(environment={}), {})
    assert [program.key for program in launch.programs] == [AMCL, "nav2_planner/planner_server"]
    assert [program.span.text for program in launch.programs] == ["bot/amcl", "planner_server"]
    for program in launch.programs:
        assert program.parameters.files == (str(path),)
    (file,) = launch.parameters
    assert (file.path, file.exists) == (str(path), True)


@pytest.mark.parametrize(
    ("arguments", "has_amcl"),
    [
        ('"slam": "False"', True),
        ('"slam": "True"', False),
        ('"slam": LaunchConfiguration("unknown")', False),
        ('"use_localization": "True"', True),
        ('"use_localization": "False"', False),
        ('"map": "/map.yaml"', True),
    ],
)
def test_nav2_with_mapping(package: Path, arguments: str, has_amcl: bool) -> None:
    """The file is loaded, whether Nav2 localizes in a map or makes one."""
    path = add_file(package / "launch" / "a.py", INCLUDE.format(arguments))
    launch = read_launch(Source.read(path), Resolver(environment={}), {})
    keys = [program.key for program in launch.programs]
    assert "nav2_planner/planner_server" in keys
    assert (AMCL in keys) is has_amcl
    assert [file.path for file in launch.files if file.purpose == PARAMETERS] == ["/nav2.yaml"]
