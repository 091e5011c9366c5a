"""LAU027: robots whose frames RViz does not find."""

from pathlib import Path

import pytest

from tests.launched import reported

TEXT = """from launch_ros.actions import Node

nodes = [
    Node(package="robot_state_publisher", executable="robot_state_publisher"{}),
    Node(package="rviz2", executable="rviz2", arguments=["-d", "../a.rviz"]{}),
{}
]
"""
RVIZ = """Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/RobotModel
{}
"""
SPACE = ', namespace="a", remappings=[("/tf", "tf"), ("/tf_static", "tf_static")]'


def helps(directory: Path, robot: str, viewer: str, more: str, display: str) -> list[str | None]:
    text = TEXT.format(robot, viewer, more)
    files = {"a.rviz": RVIZ.format(display)}
    return [one.help for one in reported(directory / "arm", "LAU027", "a.launch.py", text, files)]


@pytest.mark.parametrize(
    ("prefix", "display", "words"),
    [
        ("a/", "", "write TF Prefix: a"),
        ("a/", "      TF Prefix: b", "write TF Prefix: a"),
        ("a/", "      TF Prefix: a", ""),
        ("a_", "", "write TF Prefix: a_, and frame_prefix: a_/, as RViz adds a slash"),
        ("/a/", "", "write TF Prefix: a"),
        ("/", "", ""),  # tf2 strips the slash
        ("", "", ""),
    ],
)
def test_prefixes(tmp_path: Path, prefix: str, display: str, words: str) -> None:
    robot = f', parameters=[{{"frame_prefix": "{prefix}"}}]'
    assert helps(tmp_path, robot, "", "", display) == [words] * bool(words)


@pytest.mark.parametrize(
    ("robot", "viewer", "more", "count"),
    [
        (SPACE, "", "", 1),
        (SPACE, ', remappings=[("/tf", "/a/tf")]', "", 0),
        (', namespace="a"', "", "", 0),
        (SPACE, "", 'Node(package="own", executable="relay"),', 0),
        (SPACE, "", 'Node(package="topic_tools", executable="relay"),', 0),
        (
            SPACE,
            "",
            'Node(package="joint_state_publisher", executable="joint_state_publisher"),',
            1,
        ),
    ],
)
def test_transforms_in_a_namespace(
    tmp_path: Path, robot: str, viewer: str, more: str, count: int
) -> None:
    words = "remap /tf to /a/tf, and /tf_static to /a/tf_static"
    assert helps(tmp_path, robot, viewer, more, "") == [words] * count
