from __future__ import annotations

import pytest

from tests.reported import messages, places, reported


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("base link", "white space in the name, at which Gazebo topics and command lines break"),
        ("base_link ", "white space at an end of the name"),
        (" base_link", "white space at an end of the name"),
        ("arm&#9;1", "white space in the name, at which Gazebo topics and command lines break"),
        ("arm::1", "'::' in the name, which Gazebo's SDF keeps for scopes"),
    ],
)
def test_the_character_and_who_minds_it(name: str, reason: str) -> None:
    shown = name.replace("&#9;", "\t")
    assert messages("NAM004", f'<link name="{name}"/>') == [f"link '{shown}': {reason}"]
    assert places("NAM004", f'<link name="{name}"/>') == [(2, name)]


@pytest.mark.parametrize(
    "name", ["base_link", "wrist_3-flange", "arm.1", "robot/base", "\u8155", "1st", "", "${a b}"]
)
def test_what_all_programs_take_or_another_rule_tells(name: str) -> None:
    assert reported("NAM004", f'<link name="{name}"/>') == []


@pytest.mark.parametrize(("kind", "count"), [("fixed", 0), ("revolute", 1), ("continuous", 1)])
def test_a_slash_in_the_name_of_a_joint_that_moves(kind: str, count: int) -> None:
    robot = f'<link name="a"/><joint name="ur5e/elbow" type="{kind}"/>'
    assert messages("NAM004", robot) == count * [
        "joint 'ur5e/elbow': '/' in the name of a joint, which ROS parameters read as a path"
    ]
