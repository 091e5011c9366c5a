"""LAU003: worlds that a launch file passes to one that it includes."""

from pathlib import Path

import pytest

from tests.launched import reported
from tests.naming import naming

INNER = """
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

share = FindPackageShare("arm")
DeclareLaunchArgument("world", default_value="hall.sdf")
world = PathJoinSubstitution([share, "worlds", LaunchConfiguration("world")])
IncludeLaunchDescription(
    PathJoinSubstitution([FindPackageShare("ros_gz_sim"), "launch", "gz_sim.launch.py"]),
    launch_arguments={"gz_args": ["-r ", world]}.items(),
)
"""
OUTER = """
from launch.actions import DeclareLaunchArgument, IncludeLaunchDescription
from launch.substitutions import LaunchConfiguration, PathJoinSubstitution
from launch_ros.substitutions import FindPackageShare

DeclareLaunchArgument("world", default_value="WORLD")
IncludeLaunchDescription(
    PathJoinSubstitution([FindPackageShare("arm"), "launch", "inner.launch.py"]),
    launch_arguments={"world": LaunchConfiguration("world")}.items(),
)
"""


@pytest.mark.parametrize(
    ("world", "lines"),
    [
        ("hall.sdf", []),
        ("hall.world", [6]),
        ("", []),
    ],
)
def test_a_world_that_is_passed(tmp_path: Path, world: str, lines: list[int]) -> None:
    files = {"launch/inner.launch.py": INNER, "worlds/hall.sdf": "<sdf/>"}
    text = OUTER.replace("WORLD", world)
    found = reported(tmp_path, "LAU003", "a.launch.py", text, files)
    assert [one.span.line for one in found] == lines
    assert [one.span.text for one in found] == [world] * len(lines)


def test_a_default_is_reported_where_it_is_written(tmp_path: Path) -> None:
    """A launch file that passes nothing has no finding of its own."""
    files = {"launch/inner.launch.py": INNER.replace("hall.sdf", "hall.world")}
    text = OUTER.replace('{"world": LaunchConfiguration("world")}', "{}").replace('"world"', '"x"')
    assert reported(tmp_path, "LAU003", "a.launch.py", text, files) == []
    (found,) = reported(tmp_path, "LAU003", "inner.launch.py", files["launch/inner.launch.py"])
    assert found.message == naming(f"{tmp_path}/worlds/hall.world")


@pytest.mark.parametrize(("world", "count"), [("hall", 0), ("hal", 1)])
def test_a_path_that_is_joined_of_parts(tmp_path: Path, world: str, count: int) -> None:
    inner = INNER.replace('[share, "worlds", LaunchConfiguration("world")]', "[WORLD]")
    files = {
        "launch/inner.launch.py": inner.replace("WORLD", 'LaunchConfiguration("world")'),
        "worlds/hall.sdf": "<sdf/>",
    }
    joined = '[FindPackageShare("arm"), "/worlds/", LaunchConfiguration("world"), ".sdf"]'
    text = OUTER.replace('"world": LaunchConfiguration("world")', f'"world": {joined}')
    found = reported(tmp_path, "LAU003", "a.launch.py", text.replace("WORLD", world), files)
    assert [one.message.startswith("world not found") for one in found] == [True] * count
