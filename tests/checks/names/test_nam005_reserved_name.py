from __future__ import annotations

import pytest

from tests.reported import messages, reported
from urdfkit.text.diagnostic import Severity

BODY = '<visual><geometry><sphere radius="1"/></geometry></visual>'
JOINT = '<joint name="{}" type="fixed"><parent link="{}"/><child link="{}"/></joint>'


@pytest.mark.parametrize(
    ("robot", "message"),
    [
        (
            f'<link name="world">{BODY}</link>',
            "link 'world': Gazebo takes it for the world and drops its mass and shapes",
        ),
        (
            '<link name="a"/><link name="world"/>' + JOINT.format("j", "a", "world"),
            "link 'world': Gazebo and MuJoCo take it for the world, which no joint can move",
        ),
        (
            '<link name="a"/><link name="b"/>' + JOINT.format("world", "a", "b"),
            "joint 'world': in Gazebo's SDF this is the name of the world",
        ),
        (
            '<link name="__a__"/>',
            "link '__a__': names in double underscores belong to Gazebo's SDF",
        ),
    ],
)
def test_who_keeps_the_name(robot: str, message: str) -> None:
    assert messages("NAM005", robot) == [message]


@pytest.mark.parametrize(
    ("targets", "severity"),
    [((), Severity.INFO), (("ros2",), Severity.INFO), (("gz-harmonic",), Severity.WARNING)],
)
def test_others_take_the_name(targets: tuple[str, ...], severity: Severity) -> None:
    (finding,) = reported("NAM005", f'<link name="world">{BODY}</link>', targets=targets)
    assert finding.severity is severity


@pytest.mark.parametrize(
    "robot",
    [
        '<link name="world"/><link name="b"/>' + JOINT.format("fix", "world", "b"),
        '<link name="world_link"/>',
        '<link name="__a"/>',
        '<link name="____"/>',
    ],
)
def test_an_empty_world_that_fixes_the_robot_is_right(robot: str) -> None:
    assert reported("NAM005", robot) == []
